#include "rovio_sfm/app/sensor_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool SensorOptions::IsValid(std::string* error) const {
  OptionChecker checker("sensors", error);
  checker.Range("image_latency_s", image_latency_s, -1.0, 1.0);
  checker.Range("odom_latency_s", odom_latency_s, -1.0, 1.0);
  checker.Range("max_odom_gap_s", max_odom_gap_s, 0.01, 10.0);
  checker.Range("odom_memory_s", odom_memory_s, 1.0, 1e6);
  return checker.Passed();
}

}  // namespace rovio_sfm
