#include "rovio_sfm/scene/ids.h"

#include <algorithm>

namespace rovio_sfm {

std::string DriveId::ToString() const {
  return robot + "-" + std::to_string(start_ns) + "-" + std::to_string(nonce);
}

std::string FrameId::ToString() const { return drive.ToString() + "/" + std::to_string(index); }

bool IsValidRobotName(const std::string& name, std::string* error) {
  const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_name = [&](char c) { return is_lower(c) || (c >= '0' && c <= '9') || c == '_'; };
  const bool valid = !name.empty() && name.size() <= 32 && is_lower(name.front()) &&
                     std::all_of(name.begin(), name.end(), is_name);
  if (!valid) {
    *error = "robot '" + name.substr(0, 64) +
             "': expected 1 to 32 characters a-z, 0-9 or _, beginning with a letter";
  }
  return valid;
}

}  // namespace rovio_sfm
