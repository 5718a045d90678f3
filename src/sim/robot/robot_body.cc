#include "rovio_sfm/sim/robot/robot_body.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm::sim {
namespace {

constexpr double kArmForward_m = 0.08;
constexpr double kLow_m = 0.12, kHigh_m = 0.28;
constexpr double kMaxTilt_rad = Radians(0.5);
constexpr double kMaxHeight_m = 0.002;

double BoundedGaussian(double bound, Rng& rng) {
  return std::clamp(0.45 * bound * rng.Gaussian(), -bound, bound);
}

}  // namespace

Camera RovioCamera() {
  Camera camera;
  camera.fx = 699.282;
  camera.fy = 687.529;
  camera.cx = 322.005;
  camera.cy = 227.160;
  camera.k1 = 0.021784;
  camera.k2 = -0.109756;
  camera.width = 640;
  camera.height = 480;
  return camera;
}

Camera DrawCalibration(const Camera& truth, Rng& rng) {
  constexpr double kFocalSigma = 0.005, kCenterSigma_px = 2.0;
  const auto draw = [&rng](double sigma) {
    return std::clamp(sigma * rng.Gaussian(), -3.0 * sigma, 3.0 * sigma);
  };
  Camera found = truth;
  const double focal = 1.0 + draw(kFocalSigma);
  found.fx *= focal;
  found.fy *= focal;
  found.cx += draw(kCenterSigma_px);
  found.cy += draw(kCenterSigma_px);
  return found;
}

Camera ScaleCamera(const Camera& camera, int width, int height) {
  const double x = static_cast<double>(width) / camera.width;
  const double y = static_cast<double>(height) / camera.height;
  Camera scaled = camera;
  scaled.fx *= x;
  scaled.fy *= y;
  scaled.cx = (camera.cx + 0.5) * x - 0.5;
  scaled.cy = (camera.cy + 0.5) * y - 0.5;
  scaled.width = width;
  scaled.height = height;
  return scaled;
}

Rigid3 BaseFromCamera(double head_position) {
  const double raised = std::clamp((kHeadDown - head_position) / (kHeadDown - kHeadUp), 0.0, 1.0);
  Eigen::Matrix3d rotation;
  rotation << 0, 0, 1,  //
      -1, 0, 0,         //
      0, -1, 0;
  return {Eigen::Quaterniond(rotation), {kArmForward_m, 0.0, kLow_m + raised * (kHigh_m - kLow_m)}};
}

Rocking DrawRocking(Rng& rng) {
  return {BoundedGaussian(kMaxTilt_rad, rng), BoundedGaussian(kMaxTilt_rad, rng),
          BoundedGaussian(kMaxHeight_m, rng)};
}

Rigid3 WorldFromBase(double x_m, double y_m, double yaw_rad, const Rocking& rocking) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const Eigen::Quaterniond rotation = AngleAxisd(yaw_rad, Vector3d::UnitZ()) *
                                      AngleAxisd(rocking.pitch_rad, Vector3d::UnitY()) *
                                      AngleAxisd(rocking.roll_rad, Vector3d::UnitX());
  return {rotation, {x_m, y_m, rocking.height_m}};
}

}  // namespace rovio_sfm::sim
