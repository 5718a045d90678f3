#include "rovio_sfm/geometry/sim3.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

const Sim3 kBFromA{2.5, Eigen::Quaterniond(0.8, 0.2, -0.5, 0.1).normalized(), {1.0, -2.0, 3.0}};
const Sim3 kCFromB{0.3, Eigen::Quaterniond(0.1, -0.7, 0.3, 0.6).normalized(), {-4.0, 0.5, 2.0}};
const Eigen::Vector3d kPoint(0.3, -0.7, 2.0);

std::vector<Eigen::Vector3d> RandomPoints(int count) {
  Rng rng(5);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(rng.Uniform(-1, 1), rng.Uniform(-1, 1), rng.Uniform(-1, 1));
  }
  return points;
}

std::vector<Eigen::Vector3d> Move(const Sim3& b_from_a, std::vector<Eigen::Vector3d> points) {
  for (Eigen::Vector3d& point : points) point = b_from_a * point;
  return points;
}

void ExpectNear(const Sim3& actual, const Sim3& expected, double tolerance) {
  EXPECT_NEAR(actual.scale, expected.scale, tolerance);
  EXPECT_LT(RotationAngle(actual.rotation * expected.rotation.conjugate()), tolerance);
  EXPECT_LT((actual.translation - expected.translation).norm(), tolerance);
}

TEST(Sim3, ProductAppliesOneAfterTheOther) {
  EXPECT_LT(((kCFromB * kBFromA) * kPoint - kCFromB * (kBFromA * kPoint)).norm(), 1e-12);
}

TEST(Sim3, InverseTakesBack) {
  EXPECT_LT((Inverse(kBFromA) * (kBFromA * kPoint) - kPoint).norm(), 1e-12);
}

TEST(TransformCamera, KeepsTheDirectionOfWhatTheCameraSees) {
  const Rigid3 cam_from_a{Eigen::Quaterniond(0.9, 0.1, 0.3, -0.2).normalized(), {0.1, 0.2, -0.3}};
  const Rigid3 cam_from_b = TransformCamera(kBFromA, cam_from_a);
  const Eigen::Vector3d x_in_b = kBFromA * kPoint;
  EXPECT_LT((cam_from_b * x_in_b - kBFromA.scale * (cam_from_a * kPoint)).norm(), 1e-12);
  EXPECT_LT((OriginInA(cam_from_b) - kBFromA * OriginInA(cam_from_a)).norm(), 1e-12);
}

TEST(AlignPoints, IsExactWithoutNoise) {
  const auto points = RandomPoints(10);
  const auto b_from_a = AlignPoints(points, Move(kBFromA, points));
  ASSERT_TRUE(b_from_a);
  ExpectNear(*b_from_a, kBFromA, 1e-7);
}

TEST(AlignPoints, IsExactOnThreePointsAndOnAPlane) {
  for (const int count : {3, 20}) {
    auto points = RandomPoints(count);
    for (Eigen::Vector3d& point : points) point.z() = 0.5;
    const auto b_from_a = AlignPoints(points, Move(kBFromA, points));
    ASSERT_TRUE(b_from_a);
    ExpectNear(*b_from_a, kBFromA, 1e-7);
  }
}

TEST(AlignPoints, StaysNearWithNoise) {
  const auto points = RandomPoints(200);
  auto moved = Move(kBFromA, points);
  Rng rng(6);
  for (Eigen::Vector3d& point : moved) {
    point += 0.01 * Eigen::Vector3d(rng.Gaussian(), rng.Gaussian(), rng.Gaussian());
  }
  ExpectNear(*AlignPoints(points, moved), kBFromA, 0.01);
}

TEST(AlignPoints, NeverReturnsAReflection) {
  const auto points = RandomPoints(20);
  auto mirrored = points;
  for (Eigen::Vector3d& point : mirrored) point.x() = -point.x();
  const auto b_from_a = AlignPoints(points, mirrored);
  ASSERT_TRUE(b_from_a);
  EXPECT_NEAR(b_from_a->rotation.norm(), 1.0, 1e-12);
  EXPECT_GT(b_from_a->scale, 0.0);
}

TEST(AlignPoints, RefusesTooFewUnequalAndCollinearPoints) {
  EXPECT_FALSE(AlignPoints({}, {}));
  const auto points = RandomPoints(5);
  EXPECT_FALSE(AlignPoints({points[0], points[1]}, {points[0], points[1]}));
  EXPECT_FALSE(AlignPoints(points, {points[0]}));
  const std::vector<Eigen::Vector3d> line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  EXPECT_FALSE(AlignPoints(line, line));
  const std::vector<Eigen::Vector3d> same(4, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(AlignPoints(same, same));
}

}  // namespace
}  // namespace rovio_sfm
