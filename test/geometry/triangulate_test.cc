#include "rovio_sfm/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

Rigid3 CameraAt(const Eigen::Vector3d& center, double yaw_rad = 0.0) {
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitY()));
  return {rotation, rotation * -center};
}

std::vector<Eigen::Vector2d> Project(const std::vector<Rigid3>& cams_from_map,
                                     const Eigen::Vector3d& point) {
  std::vector<Eigen::Vector2d> seen;
  for (const Rigid3& cam_from_map : cams_from_map) {
    seen.push_back((cam_from_map * point).hnormalized());
  }
  return seen;
}

const std::vector<Rigid3> kCameras = {CameraAt({0, 0, 0}), CameraAt({0.2, 0, 0.1}, 0.05),
                                      CameraAt({0.5, 0.1, 0}, -0.1)};
const Eigen::Vector3d kPoint(0.3, -0.2, 3.0);

TEST(TriangulateLinear, IsExactWithoutNoise) {
  const auto point = TriangulateLinear(kCameras, Project(kCameras, kPoint));
  ASSERT_TRUE(point);
  EXPECT_LT((*point - kPoint).norm(), 1e-9);
}

TEST(TriangulateLinear, DoesNotDependOnOriginAndUnit) {
  const double scale = 1e-4;
  const Eigen::Vector3d shift(40.0, -7.0, 12.0);
  std::vector<Rigid3> cams;
  for (const Rigid3& cam : kCameras) {
    const Eigen::Vector3d center = scale * OriginInA(cam) + shift;
    cams.push_back({cam.rotation, cam.rotation * -center});
  }
  const auto point = TriangulateLinear(cams, Project(kCameras, kPoint));
  ASSERT_TRUE(point);
  EXPECT_LT((*point - (scale * kPoint + shift)).norm(), 1e-9);
}

TEST(TriangulateLinear, StaysNearWithNoise) {
  Rng rng(3);
  std::vector<Eigen::Vector2d> seen = Project(kCameras, kPoint);
  for (Eigen::Vector2d& x : seen) x += 1e-3 * Eigen::Vector2d(rng.Gaussian(), rng.Gaussian());
  const auto point = TriangulateLinear(kCameras, seen);
  ASSERT_TRUE(point);
  EXPECT_LT((*point - kPoint).norm(), 0.1);
}

TEST(TriangulateLinear, RefusesTooFewOrUnequalViews) {
  EXPECT_FALSE(TriangulateLinear({}, {}));
  EXPECT_FALSE(TriangulateLinear({kCameras[0]}, {{0.0, 0.0}}));
  EXPECT_FALSE(TriangulateLinear(kCameras, {{0.0, 0.0}, {0.1, 0.0}}));
}

TEST(TriangulateLinear, RefusesCamerasInOnePlace) {
  const std::vector<Rigid3> cams = {CameraAt({1, 2, 3}), CameraAt({1, 2, 3}, 0.2)};
  EXPECT_FALSE(TriangulateLinear(cams, Project(cams, {1, 2, 9})));
}

TEST(TriangulateLinear, RefusesParallelRaysAndRaysAlongTheBaseline) {
  const std::vector<Rigid3> sideways = {CameraAt({0, 0, 0}), CameraAt({1, 0, 0})};
  EXPECT_FALSE(TriangulateLinear(sideways, {{0.1, 0.1}, {0.1, 0.1}}));
  const std::vector<Rigid3> forward = {CameraAt({0, 0, 0}), CameraAt({0, 0, 1})};
  EXPECT_FALSE(TriangulateLinear(forward, {{0.0, 0.0}, {0.0, 0.0}}));
}

TEST(TriangulateLinear, RefusesAPointBehindTheCameras) {
  EXPECT_FALSE(TriangulateLinear(kCameras, Project(kCameras, -kPoint)));
}

TEST(RefinePoint, FindsTheMinimumOfTheReprojectionError) {
  const auto refined =
      RefinePoint(kCameras, Project(kCameras, kPoint), kPoint + Eigen::Vector3d(0.05, 0.02, 0.2));
  ASSERT_TRUE(refined);
  EXPECT_LT((*refined - kPoint).norm(), 1e-5);
}

TEST(RefinePoint, HasAVanishingGradientWithNoise) {
  std::vector<Eigen::Vector2d> seen = Project(kCameras, kPoint);
  seen[0] += Eigen::Vector2d(2e-3, -1e-3);
  seen[2] += Eigen::Vector2d(-1e-3, 2e-3);
  const auto refined = RefinePoint(kCameras, seen, kPoint, 10);
  ASSERT_TRUE(refined);
  const auto cost = [&](const Eigen::Vector3d& point) {
    double sum = 0.0;
    for (size_t i = 0; i < seen.size(); ++i) {
      sum += std::pow(*ReprojectionError(kCameras[i], seen[i], point), 2);
    }
    return sum;
  };
  const double step = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d delta = step * Eigen::Vector3d::Unit(k);
    EXPECT_NEAR((cost(*refined + delta) - cost(*refined - delta)) / (2 * step), 0.0, 1e-8);
  }
}

TEST(RefinePoint, RefusesAPointBehindACameraAndUndeterminedViews) {
  EXPECT_FALSE(RefinePoint(kCameras, Project(kCameras, kPoint), -kPoint));
  const std::vector<Rigid3> cams = {CameraAt({0, 0, 0}), CameraAt({0, 0, 0}, 0.2)};
  EXPECT_FALSE(RefinePoint(cams, Project(cams, kPoint), kPoint + Eigen::Vector3d(0.1, 0, 0)));
  EXPECT_FALSE(RefinePoint({}, {}, kPoint));
}

TEST(ParallaxAngle, IsTheAngleAtThePoint) {
  EXPECT_NEAR(ParallaxAngle({-1, 0, 0}, {1, 0, 0}, {0, 0, 1}), M_PI / 2, 1e-12);
  EXPECT_NEAR(ParallaxAngle({0, 0, 0}, {0, 0, 0}, {0, 0, 1}), 0.0, 1e-12);
  EXPECT_NEAR(ParallaxAngle({0, 0, 0}, {0, 0, 2}, {0, 0, 1}), M_PI, 1e-12);
}

TEST(ReprojectionError, IsADistanceAndNothingBehindTheCamera) {
  EXPECT_NEAR(*ReprojectionError(kCameras[0], {0.13, -0.04}, {0.2, 0.0, 2.0}), 0.05, 1e-12);
  EXPECT_FALSE(ReprojectionError(kCameras[0], {0.0, 0.0}, {0.0, 0.0, -1.0}));
  EXPECT_FALSE(ReprojectionError(kCameras[0], {0.0, 0.0}, {0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace rovio_sfm
