#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "rovio_sfm/sim/robot/omni_wheels.h"
#include "rovio_sfm/sim/tour/tour.h"
#include "rovio_sfm/sim/world/render_image.h"

namespace rovio_sfm::sim {

// One picture of a tour, before it is rendered.
struct TourFrame {
  double time_s = 0.0;
  CameraMotion motion;                // over the exposure: the robot stands but still sways
  Rigid3 world_from_camera;           // the true pose, at mid exposure
  double exposure = 1.0;              // gain on the light
  Eigen::Vector3d odometry{0, 0, 0};  // odom_from_base: x m, y m, yaw rad
  Eigen::Matrix3d odometry_covariance = Eigen::Matrix3d::Zero();
};

struct SimulatedTour {
  Rigid3 base_from_camera;  // nominal, as the robot knows it
  std::vector<TourFrame> frames;
};

// Poses, exposure and odometry of every picture; the odometry is what the driver makes of the ticks
// of each step. Slip and lost ticks draw from a generator of their own, so that they never change
// the pictures.
SimulatedTour SimulateTour(const TourSpec& tour, const SlipOptions& slip, uint64_t seed);

}  // namespace rovio_sfm::sim
