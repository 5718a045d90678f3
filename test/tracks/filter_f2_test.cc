#include "rovio_sfm/tracks/filter_f2.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

constexpr double kSigma = 1.0 / 620.0;

// A landmark at the position given, seen exactly where the point of the world is.
LandmarkViews MakeLandmark(const SyntheticWorld& world, const Eigen::Vector3d& point,
                           const std::vector<size_t>& cams, const Eigen::Vector3d& position) {
  LandmarkViews landmark;
  landmark.position = position;
  for (const size_t cam : cams) {
    landmark.cams_from_map.push_back(world.cams_from_map[cam]);
    landmark.x_normalized.push_back((world.cams_from_map[cam] * point).hnormalized());
    landmark.sigmas.push_back(kSigma);
  }
  return landmark;
}

SyntheticWorld MakeWorld() {
  SyntheticOptions options;
  options.num_cams = 5;
  return MakeSyntheticWorld(options);
}

const Eigen::Vector3d kPoint(0.3, -0.1, 4.0);

TEST(UnitedPosition, WeighsByViewsMinusOne) {
  const SyntheticWorld world = MakeWorld();
  const LandmarkViews a = MakeLandmark(world, kPoint, {0, 1, 2, 3}, {0, 0, 1});
  const LandmarkViews b = MakeLandmark(world, kPoint, {3, 4}, {4, 0, 1});
  EXPECT_LT((UnitedPosition(a, b) - Eigen::Vector3d(1, 0, 1)).norm(), 1e-12);
}

TEST(PassesFilterF2, AcceptsTheSamePointAndRefusesAnother) {
  const SyntheticWorld world = MakeWorld();
  const Eigen::Vector3d other = kPoint + Eigen::Vector3d(0.1, 0, 0);
  const LandmarkViews a = MakeLandmark(world, kPoint, {0, 1, 2}, kPoint);
  EXPECT_TRUE(PassesFilterF2(a, MakeLandmark(world, kPoint, {3, 4}, kPoint), {}));
  EXPECT_FALSE(PassesFilterF2(a, MakeLandmark(world, other, {3, 4}, other), {}));
}

TEST(PassesFilterF2, AsksTheViewsOfBothLandmarks) {
  const SyntheticWorld world = MakeWorld();
  const Eigen::Vector3d other = kPoint + Eigen::Vector3d(0.05, 0, 0);
  // The mean lies near the landmark of more views: the other's views alone speak against it.
  const LandmarkViews many = MakeLandmark(world, kPoint, {0, 1, 2, 3}, kPoint);
  const LandmarkViews few = MakeLandmark(world, other, {3, 4}, other);
  EXPECT_FALSE(PassesFilterF2(many, few, {}));
  EXPECT_FALSE(PassesFilterF2(few, many, {}));
}

TEST(PassesFilterF2, AcceptsAPointWhoseDepthIsUncertain) {
  const SyntheticWorld world = MakeWorld();
  const LandmarkViews a = MakeLandmark(world, kPoint, {0, 1, 2}, kPoint);
  const LandmarkViews b = MakeLandmark(world, kPoint, {0, 1}, 1.01 * kPoint);
  EXPECT_TRUE(PassesFilterF2(a, b, {}));
}

TEST(PassesFilterF2, DoesNotDependOnTheOriginUnlikeTheThesis) {
  const SyntheticWorld world = MakeWorld();
  const Sim3 moved_from_map{1.0, Eigen::Quaterniond::Identity(), {-0.3, 0.1, 0.0}};
  const SyntheticWorld moved = TransformWorld(moved_from_map, world);
  const Eigen::Vector3d shift(0.002, 0.002, 0.002);
  const Eigen::Vector3d point = moved_from_map * kPoint;
  const LandmarkViews a = MakeLandmark(world, kPoint, {0, 1}, kPoint);
  const LandmarkViews b = MakeLandmark(world, kPoint, {2, 3}, kPoint + shift);
  const LandmarkViews moved_a = MakeLandmark(moved, point, {0, 1}, point);
  const LandmarkViews moved_b = MakeLandmark(moved, point, {2, 3}, point + shift);
  EXPECT_TRUE(PassesFilterF2(a, b, {}));
  EXPECT_TRUE(PassesFilterF2(moved_a, moved_b, {}));
  FilterF2Options thesis;
  thesis.method = F2Method::kMeanRelative;
  EXPECT_TRUE(PassesFilterF2(a, b, thesis));
  EXPECT_FALSE(PassesFilterF2(moved_a, moved_b, thesis));
}

TEST(FilterF2Options, NamesTheBadField) {
  std::string error;
  FilterF2Options options;
  EXPECT_TRUE(IsValid(options, &error));
  options.max_chi_square = 0.0;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("max_chi_square"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
