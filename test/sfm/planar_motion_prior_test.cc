#include "rovio_sfm/sfm/planar_motion_prior.h"

#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include "sfm/flat_drive.h"

namespace rovio_sfm {
namespace {

PlanarMotion Metric() {
  PlanarMotion planar;
  planar.metres_per_unit = kFlatMetresPerUnit;
  return planar;
}

BundleOptions With(const std::optional<PlanarMotion>& planar) {
  BundleOptions options{50, 1.0, 1e-9};
  options.planar_motion = planar;
  return options;
}

BundleProblem Adjusted(BundleProblem problem, const std::optional<PlanarMotion>& planar) {
  const BundleReport report = AdjustBundle(&problem, With(planar));
  EXPECT_TRUE(report.usable) << report.message;
  return problem;
}

void ExpectSameBytes(const BundleProblem& a, const BundleProblem& b) {
  EXPECT_EQ(a.points, b.points);
  for (size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].cam_from_map.rotation.coeffs(),
              b.cameras[i].cam_from_map.rotation.coeffs());
    EXPECT_EQ(a.cameras[i].cam_from_map.translation, b.cameras[i].cam_from_map.translation);
  }
}

TEST(PlanarMotion, HasNoResidualOnAFlatFloor) {
  for (const double turn_rad : {0.0, 0.1}) {
    FlatDriveOptions options;
    options.turn_rad = turn_rad;
    BundleProblem problem = FlatDrive(options).problem();
    const BundleReport report = AdjustBundle(&problem, With(Metric()));
    ASSERT_TRUE(report.usable);
    EXPECT_LT(report.initial_cost, 1e-12);
  }
}

TEST(PlanarMotion, StraightensAMapThatBends) {
  for (const uint64_t seed : {1, 2, 3}) {
    const FlatDriveOptions options{40, 0.0, 0.0, 0.004, 0.001, 1.0, seed, 10};
    const BundleProblem truth = FlatDrive(options).problem();
    const BundleProblem free = Adjusted(truth, {}), flat = Adjusted(truth, Metric());
    EXPECT_LT(OffPlane(flat), 0.7 * OffPlane(free));
    EXPECT_LT(RmsError(flat, truth), RmsError(free, truth));
  }
}

TEST(PlanarMotion, StraightensByTheTiltAlone_WithoutAScale) {
  const FlatDriveOptions options{40, 0.0, 0.0, 0.0, 0.0, 1.0, 1};
  BundleProblem truth = FlatDrive(options).problem();
  const BundleProblem free = Adjusted(truth, {}), flat = Adjusted(truth, PlanarMotion{});
  EXPECT_LT(OffPlane(flat), OffPlane(free));
  for (BundleCamera& camera : truth.cameras) camera.base_from_camera->translation.setConstant(1e3);
  ExpectSameBytes(Adjusted(truth, PlanarMotion{}), flat);
}

// All cameras mounted otherwise than they say, on a robot that turns.
TEST(PlanarMotion, BearsAWrongMount) {
  FlatDriveOptions options;
  options.turn_rad = 0.15;
  const BundleProblem truth = FlatDrive(options).problem();
  BundleProblem wrong = truth;
  for (BundleCamera& camera : wrong.cameras) {
    camera.base_from_camera->rotation =
        Eigen::AngleAxisd(0.02, Eigen::Vector3d(0.6, 0.8, 0.0)) * camera.base_from_camera->rotation;
  }
  PlanarMotion trusting = Metric();
  trusting.mount_sigma_rad = 1e-5;
  const BundleProblem bearing = Adjusted(wrong, Metric()), bent = Adjusted(wrong, trusting);
  EXPECT_LT(RmsError(bearing, wrong), 1e-5);
  EXPECT_GT(RmsError(bent, wrong), 10.0 * RmsError(bearing, wrong));
}

TEST(PlanarMotion, LetsARampBe) {
  FlatDriveOptions options;
  options.ramp_rad = 0.1;
  options.noise_px = 0.3;
  const BundleProblem truth = FlatDrive(options).problem();
  const BundleProblem flat = Adjusted(truth, Metric());
  EXPECT_NEAR(OffPlane(flat), OffPlane(truth), 0.05 * OffPlane(truth));
  EXPECT_LT(RmsError(flat, truth), 0.003);  // on a way of 4 m
}

TEST(PlanarMotion, SaysNothingOfCamerasWithoutABase) {
  FlatDriveOptions options;
  options.noise_px = 1.0;
  BundleProblem truth = FlatDrive(options).problem();
  const BundleProblem half = [&] {
    BundleProblem problem = truth;
    for (size_t i = 0; i < problem.cameras.size(); i += 2) {
      problem.cameras[i].base_from_camera.reset();
    }
    return problem;
  }();
  BundleProblem adjusted = half;
  EXPECT_TRUE(AdjustBundle(&adjusted, With(Metric())).usable);
  BundleProblem none = truth;
  for (BundleCamera& camera : none.cameras) camera.base_from_camera.reset();
  ExpectSameBytes(Adjusted(none, Metric()), Adjusted(none, {}));
}

TEST(PlanarMotion, IsOffByDefault_AndThenTheSameBytes) {
  EXPECT_FALSE(BundleOptions{}.planar_motion);
  FlatDriveOptions options;
  options.noise_px = 1.0;
  const BundleProblem with_base = FlatDrive(options).problem();
  BundleProblem without_base = with_base;
  for (BundleCamera& camera : without_base.cameras) camera.base_from_camera.reset();
  ExpectSameBytes(Adjusted(with_base, {}), Adjusted(without_base, {}));
}

TEST(PlanarMotion, GivesTheSameBytesTwice) {
  for (const int num_cams : {8, 40}) {  // dense and sparse
    FlatDriveOptions options;
    options.num_cams = num_cams;
    options.noise_px = 1.0;
    const BundleProblem truth = FlatDrive(options).problem();
    ExpectSameBytes(Adjusted(truth, Metric()), Adjusted(truth, Metric()));
  }
}

// Those in the middle know the plane from the fixed ones.
TEST(PlanarMotion, PullsFreeCamerasToThePlaneOfFixedOnes) {
  FlatDriveOptions options;
  options.num_cams = 20;
  BundleProblem problem = FlatDrive(options).problem();
  for (size_t i = 0; i < 20; ++i) problem.cameras[i].fixed = i < 8 || i > 11;
  options.noise_px = 3.0;
  problem.observations = FlatDrive(options).problem().observations;
  problem.points = FlatDrive(options).problem().points;
  EXPECT_LT(OffPlane(Adjusted(problem, Metric())), 0.8 * OffPlane(Adjusted(problem, {})));
}

TEST(AddPlanarMotion, AddsNothingWithoutAnObservedCamera) {
  FlatDriveOptions options;
  options.num_cams = 4;
  const BundleProblem drive = FlatDrive(options).problem();
  std::vector<PoseBlock> poses(4);
  FloorBlocks floor;
  ceres::Problem problem;
  AddPlanarMotion(drive.cameras, Metric(), &poses, &floor, &problem);
  EXPECT_EQ(problem.NumResidualBlocks(), 0);
}

}  // namespace
}  // namespace rovio_sfm
