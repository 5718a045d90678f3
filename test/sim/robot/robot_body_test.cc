#include "rovio_sfm/sim/robot/robot_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm::sim {
namespace {

TEST(BaseFromCamera, LooksForwardAndLevel) {
  const Rigid3 base_from_camera = BaseFromCamera(kHeadUp);
  const Eigen::Vector3d forward = base_from_camera.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d down = base_from_camera.rotation * Eigen::Vector3d::UnitY();
  EXPECT_NEAR((forward - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((down + Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
}

TEST(BaseFromCamera, RisesWithTheHead) {
  EXPECT_NEAR(BaseFromCamera(kHeadDown).translation.z(), 0.12, 1e-9);
  EXPECT_NEAR(BaseFromCamera(kHeadUp).translation.z(), 0.28, 1e-9);
  EXPECT_NEAR(BaseFromCamera(kHeadMiddle).translation.z(), 0.20, 0.01);
}

TEST(DrawRocking, StaysWithinItsBounds) {
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const Rocking rocking = DrawRocking(rng);
    EXPECT_LE(std::abs(rocking.pitch_rad), 0.00873);
    EXPECT_LE(std::abs(rocking.roll_rad), 0.00873);
    EXPECT_LE(std::abs(rocking.height_m), 0.002);
  }
}

TEST(DrawCalibration, ErrsByItsUncertainty) {
  const Camera truth = RovioCamera();
  Rng rng(3);
  double focal_squares = 0.0, center_squares = 0.0;
  constexpr int kDraws = 400;
  for (int i = 0; i < kDraws; ++i) {
    const Camera found = DrawCalibration(truth, rng);
    focal_squares += std::pow(found.fx / truth.fx - 1.0, 2) / kDraws;
    center_squares += std::pow(found.cx - truth.cx, 2) / kDraws;
    EXPECT_NEAR(found.fy / found.fx, truth.fy / truth.fx, 1e-12);
    EXPECT_EQ(found.k1, truth.k1);
  }
  EXPECT_NEAR(std::sqrt(focal_squares), 0.005, 0.001);
  EXPECT_NEAR(std::sqrt(center_squares), 2.0, 0.4);
}

TEST(ScaleCamera, KeepsTheFieldOfView) {
  const Camera half = ScaleCamera(RovioCamera(), 320, 240);
  EXPECT_DOUBLE_EQ(half.fx, 0.5 * RovioCamera().fx);
  EXPECT_DOUBLE_EQ(half.cx + 0.5, 0.5 * (RovioCamera().cx + 0.5));
  EXPECT_TRUE(half.IsValid(nullptr));
}

TEST(WorldFromBase, TurnsLeftForPositiveYaw) {
  const Eigen::Vector3d ahead = WorldFromBase(1, 2, M_PI / 2, {}) * Eigen::Vector3d(1, 0, 0);
  EXPECT_NEAR((ahead - Eigen::Vector3d(1, 3, 0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace rovio_sfm::sim
