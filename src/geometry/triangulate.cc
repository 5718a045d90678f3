#include "rovio_sfm/geometry/triangulate.h"

#include <Eigen/Dense>
#include <cmath>

namespace rovio_sfm {
namespace {

constexpr double kMinDepth = 1e-9;  // of the baseline or of the map's unit
constexpr double kMinEigenvalueRatio = 1e-14;
constexpr double kMinWeight = 1e-7;  // of a homogeneous point; below it lies at infinity

// A frame in which the mean camera centre is the origin and the farthest centre has distance 1, so
// that the linear equations are well conditioned whatever the map's unit and origin.
struct LocalFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double scale = 0.0;
};

std::optional<LocalFrame> FindLocalFrame(const std::vector<Rigid3>& cams_from_map) {
  LocalFrame frame;
  for (const Rigid3& cam_from_map : cams_from_map) frame.origin += OriginInA(cam_from_map);
  frame.origin /= static_cast<double>(cams_from_map.size());
  for (const Rigid3& cam_from_map : cams_from_map) {
    frame.scale = std::max(frame.scale, (OriginInA(cam_from_map) - frame.origin).norm());
  }
  if (!(frame.scale > 1e-12 * (1.0 + frame.origin.norm()))) return std::nullopt;
  return frame;
}

// A^T A of the equations (x p3 - p1) X = 0 and (y p3 - p2) X = 0, with unit rays (A.6.1).
Eigen::Matrix4d NormalMatrix(const std::vector<Rigid3>& cams_from_map,
                             const std::vector<Eigen::Vector2d>& x_normalized,
                             const LocalFrame& frame) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  for (size_t i = 0; i < cams_from_map.size(); ++i) {
    Eigen::Matrix<double, 3, 4> projection;
    projection.leftCols<3>() = cams_from_map[i].rotation.toRotationMatrix();
    projection.col(3) = (cams_from_map[i] * frame.origin) / frame.scale;
    for (int k = 0; k < 2; ++k) {
      const Eigen::RowVector4d row = x_normalized[i](k) * projection.row(2) - projection.row(k);
      normal += row.transpose() * row;
    }
  }
  return normal;
}

// Residuals' normal equations at a point; false if it is not in front of every camera.
struct PointSystem {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double cost = 0.0;
};

std::optional<PointSystem> Linearize(const std::vector<Rigid3>& cams_from_map,
                                     const std::vector<Eigen::Vector2d>& x_normalized,
                                     const Eigen::Vector3d& point_in_map) {
  PointSystem system;
  for (size_t i = 0; i < cams_from_map.size(); ++i) {
    const Eigen::Vector3d x_in_cam = cams_from_map[i] * point_in_map;
    if (!(x_in_cam.z() > kMinDepth)) return std::nullopt;
    const Eigen::Vector2d x = x_in_cam.hnormalized();
    const Eigen::Matrix3d rotation = cams_from_map[i].rotation.toRotationMatrix();
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian.row(0) = (rotation.row(0) - x.x() * rotation.row(2)) / x_in_cam.z();
    jacobian.row(1) = (rotation.row(1) - x.y() * rotation.row(2)) / x_in_cam.z();
    const Eigen::Vector2d residual = x - x_normalized[i];
    system.normal += jacobian.transpose() * jacobian;
    system.gradient += jacobian.transpose() * residual;
    system.cost += residual.squaredNorm();
  }
  return system;
}

}  // namespace

std::optional<Eigen::Vector3d> TriangulateLinear(const std::vector<Rigid3>& cams_from_map,
                                                 const std::vector<Eigen::Vector2d>& x_normalized) {
  if (cams_from_map.size() < 2 || cams_from_map.size() != x_normalized.size()) return std::nullopt;
  const std::optional<LocalFrame> frame = FindLocalFrame(cams_from_map);
  if (!frame) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(
      NormalMatrix(cams_from_map, x_normalized, *frame));
  const Eigen::Vector4d& eigenvalues = solver.eigenvalues();
  if (!(eigenvalues(1) > kMinEigenvalueRatio * eigenvalues(3))) return std::nullopt;
  const Eigen::Vector4d point = solver.eigenvectors().col(0);
  if (!(std::abs(point.w()) > kMinWeight)) return std::nullopt;
  const Eigen::Vector3d point_in_map = frame->origin + frame->scale * point.hnormalized();
  for (const Rigid3& cam_from_map : cams_from_map) {
    if (!((cam_from_map * point_in_map).z() > kMinDepth * frame->scale)) return std::nullopt;
  }
  return point_in_map;
}

std::optional<Eigen::Vector3d> RefinePoint(const std::vector<Rigid3>& cams_from_map,
                                           const std::vector<Eigen::Vector2d>& x_normalized,
                                           const Eigen::Vector3d& point_in_map, int num_steps) {
  if (cams_from_map.size() < 2 || cams_from_map.size() != x_normalized.size()) return std::nullopt;
  Eigen::Vector3d point = point_in_map;
  std::optional<PointSystem> system = Linearize(cams_from_map, x_normalized, point);
  if (!system) return std::nullopt;
  for (int step = 0; step < num_steps; ++step) {
    const Eigen::LDLT<Eigen::Matrix3d> solver(system->normal);
    const Eigen::Vector3d pivots = solver.vectorD();
    if (!(pivots.minCoeff() > kMinEigenvalueRatio * pivots.maxCoeff())) return std::nullopt;
    const Eigen::Vector3d candidate = point - solver.solve(system->gradient);
    const std::optional<PointSystem> next = Linearize(cams_from_map, x_normalized, candidate);
    if (!next || !(next->cost < system->cost)) break;
    point = candidate;
    system = next;
  }
  return point;
}

double ParallaxAngle(const Eigen::Vector3d& center_a, const Eigen::Vector3d& center_b,
                     const Eigen::Vector3d& point) {
  const Eigen::Vector3d ray_a = point - center_a;
  const Eigen::Vector3d ray_b = point - center_b;
  return std::atan2(ray_a.cross(ray_b).norm(), ray_a.dot(ray_b));
}

std::optional<double> ReprojectionError(const Rigid3& cam_from_map,
                                        const Eigen::Vector2d& x_normalized,
                                        const Eigen::Vector3d& point_in_map) {
  const Eigen::Vector3d x_in_cam = cam_from_map * point_in_map;
  if (!(x_in_cam.z() > kMinDepth)) return std::nullopt;
  return (x_in_cam.hnormalized() - x_normalized).norm();
}

}  // namespace rovio_sfm
