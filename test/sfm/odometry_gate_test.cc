#include "rovio_sfm/sfm/odometry_gate.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

// A camera that looks along the base's x axis from 0.2 m above the floor.
Rigid3 BaseFromCamera() {
  Eigen::Matrix3d base_from_optical;
  base_from_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(base_from_optical), {0.1, 0.0, 0.2}};
}

Rigid3 At(double x_m, double y_m, double yaw_rad) {
  return *OdomFromCamera(OdometrySample{x_m, y_m, yaw_rad, {}}, BaseFromCamera());
}

PairMatches TruePair(const Rigid3& odom_from_other, const Rigid3& odom_from_camera) {
  PairMatches pair;
  pair.verdict = PairVerdict::kGeneral;
  pair.cam_from_other = Inverse(odom_from_camera) * odom_from_other;
  pair.cam_from_other.translation.normalize();
  return pair;
}

OdometryGateOptions Enabled() {
  OdometryGateOptions options;
  options.enabled = true;
  return options;
}

TEST(OdometryGate, LetsTheTrueMotionThrough) {
  const Rigid3 other = At(0.0, 0.0, 0.0), camera = At(0.3, 0.1, 0.2);
  EXPECT_TRUE(PassesOdometryGate(TruePair(other, camera), other, camera, Enabled()));
}

TEST(OdometryGate, RefusesTheOppositeDirection) {
  const Rigid3 other = At(0.0, 0.0, 0.0), camera = At(0.3, 0.0, 0.0);
  PairMatches pair = TruePair(other, camera);
  pair.cam_from_other.translation *= -1.0;
  EXPECT_FALSE(PassesOdometryGate(pair, other, camera, Enabled()));
}

TEST(OdometryGate, RefusesARotationTheWheelsDoNotKnow) {
  const Rigid3 other = At(0.0, 0.0, 0.0), camera = At(0.3, 0.0, 0.0);
  const PairMatches turned = TruePair(other, At(0.3, 0.0, 0.5));
  EXPECT_FALSE(PassesOdometryGate(turned, other, camera, Enabled()));
}

TEST(OdometryGate, ComparesNoDirectionOfAShortMove) {
  const Rigid3 other = At(0.0, 0.0, 0.0), camera = At(0.01, 0.0, 0.0);
  PairMatches pair = TruePair(other, camera);
  pair.cam_from_other.translation *= -1.0;
  EXPECT_TRUE(PassesOdometryGate(pair, other, camera, Enabled()));
}

TEST(OdometryGate, IsOpenUnlessEnabled) {
  const Rigid3 other = At(0.0, 0.0, 0.0), camera = At(0.3, 0.0, 0.0);
  const PairMatches turned = TruePair(other, At(0.3, 0.0, 2.0));
  EXPECT_TRUE(PassesOdometryGate(turned, other, camera, {}));
}

TEST(OdometryGate, KnowsNoPoseWithoutWheelsOrHead) {
  EXPECT_FALSE(OdomFromCamera(std::nullopt, BaseFromCamera()).has_value());
  EXPECT_FALSE(OdomFromCamera(OdometrySample{}, std::nullopt).has_value());
}

TEST(OdometryGateOptions, NameTheBoundThatIsBroken) {
  OdometryGateOptions options;
  options.max_rotation_gap_deg = 200.0;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("max_rotation_gap_deg"), std::string::npos) << error;
}

}  // namespace
}  // namespace rovio_sfm
