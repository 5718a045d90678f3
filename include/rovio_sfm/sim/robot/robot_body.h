#pragma once

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {

// The published calibration of a real Rovio at 640 x 480 (rovio-http.md, "Lens").
Camera RovioCamera();

// What a careful calibration of that camera finds: focal lengths off by 0.5 %, the centre by 2 px,
// one sigma each, three at most.
Camera DrawCalibration(const Camera& truth, Rng& rng);

// The same lens at another size of picture: the sensor is scaled, not cropped.
Camera ScaleCamera(const Camera& camera, int width, int height);

// Where a robot stands on the floor of the world.
struct PlanarPose {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

// Where the camera sits for a head position as GetMCUReport tells it: about 204 down, 135 middle,
// 65 up. Base: x forward, y left, z up, on the floor under the robot's middle. Camera: x right,
// y down, z forward. The arm lifts it from 0.12 m to 0.28 m; it looks level at every height.
Rigid3 BaseFromCamera(double head_position);

inline constexpr double kHeadDown = 203.0, kHeadMiddle = 136.0, kHeadUp = 65.0;

// How far the body is off its nominal pose on the floor.
struct Rocking {
  double pitch_rad = 0.0, roll_rad = 0.0;  // about y and x of the base, within ±0.5 deg
  double height_m = 0.0;                   // within ±2 mm
};

Rocking DrawRocking(Rng& rng);

// The true pose of the base of a robot that stands at (x, y, yaw) and rocks.
Rigid3 WorldFromBase(double x_m, double y_m, double yaw_rad, const Rocking& rocking);

}  // namespace rovio_sfm::sim
