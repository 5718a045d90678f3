#pragma once

#include <string>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// Where the camera sits on the robot. The arm lifts it evenly with the head position that the robot
// reports (about 204 down, 65 up); the camera keeps its pitch. Not published anywhere: measure it.
struct HeadGeometryOptions {
  double camera_forward_m = 0.08;  // of the camera before the robot's centre
  double camera_left_m = 0.0;
  double camera_height_down_m = 0.12;  // above the floor
  double camera_height_up_m = 0.28;
  double camera_pitch_rad = 0.0;  // positive looks down
  int head_position_down = 203;
  int head_position_up = 65;

  bool IsValid(std::string* error) const;
};

// base_from_camera_link for a reported head position; camera_link: x forward, y left, z up.
Rigid3 BaseFromCameraLink(int head_position, const HeadGeometryOptions& options);

// camera_link_from_optical: optical is x right, y down, z forward.
Rigid3 CameraLinkFromOptical();

}  // namespace rovio_sfm
