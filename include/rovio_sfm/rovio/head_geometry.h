#pragma once

#include <string>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Where the camera sits on the robot. The arm lifts it evenly with the head position that the robot
// reports (about 204 down, 65 up); the camera keeps its pitch. Not published anywhere: measure it.
struct HeadGeometryOptions {
  double camera_forward_m = 0.08;
  double camera_left_m = 0.0;
  double camera_height_down_m = 0.12;
  double camera_height_up_m = 0.28;
  double camera_pitch_rad = 0.0;
  int head_position_down = 203;
  int head_position_up = 65;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("camera_forward_m", camera_forward_m, -2.0, 2.0, "before the robot's centre");
    table.AddNumber("camera_left_m", camera_left_m, -2.0, 2.0, "of the robot's centre");
    table.AddNumber("camera_height_down_m", camera_height_down_m, -2.0, 2.0, "above the floor");
    table.AddNumber("camera_height_up_m", camera_height_up_m, -2.0, 2.0, "above the floor");
    table.AddDegrees("camera_pitch_deg", camera_pitch_rad, -85.0, 85.0, "positive looks down");
    table.AddNumber("head_position_down", head_position_down, 0, 255, "the robot's number");
    table.AddNumber("head_position_up", head_position_up, 0, 255, "the robot's number");
    table.AddRule("head_position_down", head_position_down > head_position_up,
                  "above head_position_up");
  }
};

// base_from_camera_link for a reported head position; camera_link: x forward, y left, z up.
Rigid3 BaseFromCameraLink(int head_position, const HeadGeometryOptions& options);

// camera_link_from_optical: optical is x right, y down, z forward.
Rigid3 CameraLinkFromOptical();

}  // namespace rovio_sfm
