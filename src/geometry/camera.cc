#include "rovio_sfm/geometry/camera.h"

#include <Eigen/LU>
#include <cmath>
#include <sstream>
#include <tuple>

namespace rovio_sfm {
namespace {

constexpr int kMaxNewtonSteps = 50;
constexpr double kConvergedPx = 1e-7;
constexpr double kAcceptedPx = 1e-3;

struct Distorted {
  Eigen::Vector2d point;
  Eigen::Matrix2d jacobian;  // of the distorted by the undistorted point
};

Distorted Distort(const Camera& c, const Eigen::Vector2d& p) {
  const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
  const double radial = 1.0 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  const double slope = 2.0 * (c.k1 + r2 * (2.0 * c.k2 + r2 * 3.0 * c.k3));  // d radial / d r2 * 2
  Distorted d;
  d.point = {x * radial + 2.0 * c.p1 * x * y + c.p2 * (r2 + 2.0 * x * x),
             y * radial + c.p1 * (r2 + 2.0 * y * y) + 2.0 * c.p2 * x * y};
  const double cross = x * y * slope + 2.0 * c.p1 * x + 2.0 * c.p2 * y;
  d.jacobian << radial + x * x * slope + 2.0 * c.p1 * y + 6.0 * c.p2 * x, cross, cross,
      radial + y * y * slope + 6.0 * c.p1 * y + 2.0 * c.p2 * x;
  return d;
}

}  // namespace

bool operator==(const Camera& a, const Camera& b) {
  const auto tie = [](const Camera& c) {
    return std::tie(c.fx, c.fy, c.cx, c.cy, c.k1, c.k2, c.p1, c.p2, c.k3, c.width, c.height);
  };
  return tie(a) == tie(b);
}

bool Camera::IsValid(std::string* error) const {
  const auto fail = [&](const char* field, double value, const char* expected) {
    std::ostringstream out;
    out << "camera " << field << " = " << value << ": expected " << expected;
    *error = out.str();
    return false;
  };
  if (width < 16 || width > 16384) return fail("width", width, "16 to 16384 px");
  if (height < 16 || height > 16384) return fail("height", height, "16 to 16384 px");
  if (!(fx > 1.0 && fx < 1e6)) return fail("fx", fx, "1 to 1e6 px");
  if (!(fy > 1.0 && fy < 1e6)) return fail("fy", fy, "1 to 1e6 px");
  if (!(std::abs(cx) < 1e6)) return fail("cx", cx, "a finite number of px");
  if (!(std::abs(cy) < 1e6)) return fail("cy", cy, "a finite number of px");
  for (const auto& [name, value] :
       {std::pair{"k1", k1}, {"k2", k2}, {"p1", p1}, {"p2", p2}, {"k3", k3}}) {
    if (!(std::abs(value) < 100.0)) return fail(name, value, "a distortion below 100");
  }
  return true;
}

Camera CorrectedCamera(const Camera& camera, const Eigen::Vector3d& correction) {
  Camera corrected = camera;
  corrected.fx *= 1.0 + correction[0];
  corrected.fy *= 1.0 + correction[0];
  corrected.cx += camera.fx * correction[1];
  corrected.cy += camera.fy * correction[2];
  return corrected;
}

Eigen::Vector3d CorrectionOf(const Camera& camera, const Camera& corrected) {
  return {corrected.fx / camera.fx - 1.0, (corrected.cx - camera.cx) / camera.fx,
          (corrected.cy - camera.cy) / camera.fy};
}

Eigen::Vector2d PixelFromNormalized(const Camera& camera, const Eigen::Vector2d& x_normalized) {
  const Eigen::Vector2d d = Distort(camera, x_normalized).point;
  return {camera.fx * d.x() + camera.cx, camera.fy * d.y() + camera.cy};
}

std::optional<Eigen::Vector2d> NormalizedFromPixel(const Camera& camera,
                                                   const Eigen::Vector2d& x_px) {
  const Eigen::Vector2d target((x_px.x() - camera.cx) / camera.fx,
                               (x_px.y() - camera.cy) / camera.fy);
  Eigen::Vector2d point = target;
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    const Distorted d = Distort(camera, point);
    const double determinant = d.jacobian.determinant();
    // Beyond the radius where the distortion folds back, no unique point exists.
    if (!(determinant > 1e-6)) return std::nullopt;
    const Eigen::Vector2d delta = d.jacobian.inverse() * (target - d.point);
    point += delta;
    if (delta.norm() * camera.MeanFocal() < kConvergedPx) break;
  }
  const double residual_px = (PixelFromNormalized(camera, point) - x_px).norm();
  if (!(residual_px < kAcceptedPx)) return std::nullopt;
  return point;
}

Eigen::Matrix<double, 2, 3> NormalizedByCorrection(const Camera& camera,
                                                   const Eigen::Vector2d& x_normalized) {
  const Distorted d = Distort(camera, x_normalized);
  Eigen::Matrix<double, 2, 3> distorted_by_correction;
  distorted_by_correction << d.point, Eigen::Matrix2d::Identity();
  return -d.jacobian.inverse() * distorted_by_correction;
}

}  // namespace rovio_sfm
