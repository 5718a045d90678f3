#include "rovio_sfm/geometry/rigid3.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

const Rigid3 kBFromA{Eigen::Quaterniond(0.8, 0.2, -0.5, 0.1).normalized(), {1.0, -2.0, 3.0}};
const Rigid3 kCFromB{Eigen::Quaterniond(0.1, -0.7, 0.3, 0.6).normalized(), {-4.0, 0.5, 2.0}};
const Eigen::Vector3d kPoint(0.3, -0.7, 2.0);

TEST(Rigid3, IdentityLeavesPointsAlone) { EXPECT_EQ(Rigid3() * kPoint, kPoint); }

TEST(Rigid3, ProductAppliesOneAfterTheOther) {
  EXPECT_LT(((kCFromB * kBFromA) * kPoint - kCFromB * (kBFromA * kPoint)).norm(), 1e-12);
}

TEST(Rigid3, InverseTakesBack) {
  EXPECT_LT((Inverse(kBFromA) * (kBFromA * kPoint) - kPoint).norm(), 1e-12);
  const Rigid3 identity = kBFromA * Inverse(kBFromA);
  EXPECT_LT(identity.translation.norm() + RotationAngle(identity.rotation), 1e-7);
}

TEST(Rigid3, OriginOfBMapsToZero) { EXPECT_LT((kBFromA * OriginInA(kBFromA)).norm(), 1e-12); }

TEST(RotationAngle, IsBetweenZeroAndPiForBothSigns) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, -1).normalized()));
  EXPECT_NEAR(RotationAngle(turn), 2.5, 1e-12);
  EXPECT_NEAR(RotationAngle(Eigen::Quaterniond(-turn.coeffs())), 2.5, 1e-12);
  EXPECT_EQ(RotationAngle(Eigen::Quaterniond::Identity()), 0.0);
}

}  // namespace
}  // namespace rovio_sfm
