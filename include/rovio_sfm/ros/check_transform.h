#pragma once

#include <geometry_msgs/Transform.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "rovio_sfm/util/option_text.h"

namespace rovio_sfm {

// "translation.x = nan: expected a finite number"; empty: it is a rigid transform.
inline std::string WhyNoTransform(const geometry_msgs::Transform& message) {
  const auto& t = message.translation;
  const auto& q = message.rotation;
  const std::array<std::pair<const char*, double>, 7> numbers = {{{"translation.x", t.x},
                                                                  {"translation.y", t.y},
                                                                  {"translation.z", t.z},
                                                                  {"rotation.x", q.x},
                                                                  {"rotation.y", q.y},
                                                                  {"rotation.z", q.z},
                                                                  {"rotation.w", q.w}}};
  for (const auto& [name, value] : numbers) {
    if (!std::isfinite(value)) return name + (" = " + TextOf(value)) + ": expected a finite number";
  }
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (std::abs(norm - 1.0) <= 1e-3) return "";
  return "rotation = [" + TextOf(q.x) + ", " + TextOf(q.y) + ", " + TextOf(q.z) + ", " +
         TextOf(q.w) + "]: expected a quaternion of norm 1";
}

}  // namespace rovio_sfm
