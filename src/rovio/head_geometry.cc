#include "rovio_sfm/rovio/head_geometry.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {

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
