#include "rovio_sfm/rovio/head_geometry.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(BaseFromCameraLink, RisesWithTheHeadAndIsClamped) {
  const HeadGeometryOptions options;
  EXPECT_DOUBLE_EQ(BaseFromCameraLink(203, options).translation.z(), options.camera_height_down_m);
  EXPECT_DOUBLE_EQ(BaseFromCameraLink(65, options).translation.z(), options.camera_height_up_m);
  EXPECT_DOUBLE_EQ(BaseFromCameraLink(255, options).translation.z(), options.camera_height_down_m);
  EXPECT_NEAR(BaseFromCameraLink(134, options).translation.z(), 0.2, 1e-9);
}

TEST(BaseFromCameraLink, PositivePitchLooksDown) {
  HeadGeometryOptions options;
  options.camera_pitch_rad = 0.1;
  const Rigid3 base_from_link = BaseFromCameraLink(65, options);
  EXPECT_LT((base_from_link.rotation * Eigen::Vector3d::UnitX()).z(), -0.05);
}

TEST(CameraLinkFromOptical, LooksForwardWithImageDownBeingDown) {
  const Rigid3 link_from_optical = CameraLinkFromOptical();
  const auto turn = [&](const Eigen::Vector3d& x) { return link_from_optical.rotation * x; };
  EXPECT_LT((turn(Eigen::Vector3d::UnitZ()) - Eigen::Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((turn(Eigen::Vector3d::UnitX()) + Eigen::Vector3d::UnitY()).norm(), 1e-9);
  EXPECT_LT((turn(Eigen::Vector3d::UnitY()) + Eigen::Vector3d::UnitZ()).norm(), 1e-9);
}

TEST(HeadGeometryOptions, RefuseHeadPositionsInTheWrongOrder) {
  std::string error;
  HeadGeometryOptions options;
  EXPECT_TRUE(IsValid(options, &error));
  options.head_position_down = 60;
  EXPECT_FALSE(IsValid(options, &error));
}

}  // namespace
}  // namespace rovio_sfm
