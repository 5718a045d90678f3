#pragma once

#include <string>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// How what a robot says of itself is put together with its images.
struct SensorOptions {
  std::string base_frame;
  std::string camera_frame;
  double image_latency_s = 0.0;
  double odom_latency_s = 0.0;
  double max_odom_gap_s = 0.5;
  double odom_memory_s = 20.0;

  void DescribeOptions(OptionTable& table) {
    table.AddText("base_frame", base_frame, "tf frame of the body; empty: <robot>/base_link");
    table.AddText("camera_frame", camera_frame,
                  "tf frame of the camera, z forward; empty: the one that its images name");
    table.AddNumber("image_latency_s", image_latency_s, -1.0, 1.0, "images are stamped so late");
    table.AddNumber("odom_latency_s", odom_latency_s, -1.0, 1.0, "and samples of odometry");
    table.AddNumber("max_odom_gap_s", max_odom_gap_s, 0.01, 10.0, "wider ones stay gaps");
    table.AddNumber("odom_memory_s", odom_memory_s, 1.0, 1e6, "how long odometry is kept");
  }
};

}  // namespace rovio_sfm
