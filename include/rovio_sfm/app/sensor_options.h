#pragma once

#include <string>

namespace rovio_sfm {

// How what a robot says of itself is put together with its images.
struct SensorOptions {
  std::string base_frame;        // tf frame of the robot's body; empty: <robot>/base_link
  double image_latency_s = 0.0;  // an image was taken so long before its stamp; -1 to 1
  double odom_latency_s = 0.0;   // so was an odometry sample; -1 to 1
  double max_odom_gap_s = 0.5;   // wider gaps are not interpolated; 0.01 to 10
  double odom_memory_s = 20.0;   // how long odometry is kept; 1 to 1e6

  bool IsValid(std::string* error) const;
};

}  // namespace rovio_sfm
