#include "rovio_sfm/rovio/head_geometry.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {

bool HeadGeometryOptions::IsValid(std::string* error) const {
  const auto is_length = [](double x) { return std::abs(x) <= 2.0; };
  if (!is_length(camera_forward_m) || !is_length(camera_left_m) ||
      !is_length(camera_height_down_m) || !is_length(camera_height_up_m)) {
    *error = "camera_forward_m, camera_left_m and camera heights must be -2 … 2 m";
  } else if (!(std::abs(camera_pitch_rad) <= 1.5)) {
    *error = "camera_pitch must be -85 … 85 deg";
  } else if (head_position_down <= head_position_up || head_position_up < 0 ||
             head_position_down > 255) {
    *error = "head positions must be 0 … 255, down above up";
  } else {
    return true;
  }
  return false;
}

Rigid3 BaseFromCameraLink(int head_position, const HeadGeometryOptions& options) {
  const double span = options.head_position_down - options.head_position_up;
  const double raised = std::clamp((options.head_position_down - head_position) / span, 0.0, 1.0);
  const double height_m = options.camera_height_down_m +
                          raised * (options.camera_height_up_m - options.camera_height_down_m);
  return {Eigen::Quaterniond(Eigen::AngleAxisd(options.camera_pitch_rad, Eigen::Vector3d::UnitY())),
          {options.camera_forward_m, options.camera_left_m, height_m}};
}

Rigid3 CameraLinkFromOptical() {
  Eigen::Matrix3d link_from_optical;
  link_from_optical << 0, 0, 1,  //
      -1, 0, 0,                  //
      0, -1, 0;
  return {Eigen::Quaterniond(link_from_optical), Eigen::Vector3d::Zero()};
}

}  // namespace rovio_sfm
