#include "rovio_sfm/ros/conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rovio_sfm {
namespace {

Camera SomeCamera() {
  return {634.0, 629.0, 325.0, 259.0, 0.02, -0.1, 0.001, 0.002, 0.3, 640, 480};
}

TEST(Conversions, StampsRoundTripToTheNanosecond) {
  EXPECT_EQ(ToNanoseconds(ToTime(1600000000123456789)), 1600000000123456789);
}

TEST(Conversions, StampsOutsideTheRangeOfRosAreClamped) {
  EXPECT_EQ(ToNanoseconds(ToTime(-5)), 0);
  EXPECT_EQ(ToTime(std::numeric_limits<int64_t>::max()).sec, std::numeric_limits<uint32_t>::max());
}

TEST(Conversions, CameraRoundTripsThroughItsMessage) {
  std::string error;
  const auto camera = FromMessage(ToMessage(SomeCamera()), &error);
  ASSERT_TRUE(camera) << error;
  EXPECT_EQ(*camera, SomeCamera());
}

TEST(Conversions, CameraRoundTripsThroughCameraInfo) {
  std::string error;
  const auto camera = FromCameraInfo(ToCameraInfo(SomeCamera(), 5, "optical"), &error);
  ASSERT_TRUE(camera) << error;
  EXPECT_EQ(*camera, SomeCamera());
}

TEST(Conversions, UncalibratedCameraInfoIsRefused) {
  sensor_msgs::CameraInfo info = ToCameraInfo(SomeCamera(), 5, "optical");
  info.K.fill(0.0);
  std::string error;
  EXPECT_FALSE(FromCameraInfo(info, &error));
  EXPECT_NE(error.find("uncalibrated"), std::string::npos);
}

TEST(Conversions, FisheyeCameraInfoIsRefused) {
  sensor_msgs::CameraInfo info = ToCameraInfo(SomeCamera(), 5, "optical");
  info.distortion_model = "equidistant";
  std::string error;
  EXPECT_FALSE(FromCameraInfo(info, &error));
}

TEST(Conversions, EightCoefficientsOfWhichTheLastAreZeroAreAPlumbBob) {
  sensor_msgs::CameraInfo info = ToCameraInfo(SomeCamera(), 5, "optical");
  info.D.resize(8, 0.0);
  std::string error;
  for (const char* model : {"plumb_bob", "rational_polynomial"}) {
    info.distortion_model = model;
    const auto camera = FromCameraInfo(info, &error);
    ASSERT_TRUE(camera) << error;
    EXPECT_EQ(*camera, SomeCamera());
  }
  info.D[6] = 0.1;
  EXPECT_FALSE(FromCameraInfo(info, &error));
  EXPECT_EQ(error,
            "camera_info distortion_model rational_polynomial with 8 numbers in D: expected "
            "plumb_bob, at most 5 not zero");
}

TEST(Conversions, RegionOfTheWholeImageIsNone) {
  sensor_msgs::CameraInfo info = ToCameraInfo(SomeCamera(), 5, "optical");
  info.roi.width = info.width;
  info.roi.height = info.height;
  std::string error;
  EXPECT_TRUE(FromCameraInfo(info, &error)) << error;
  info.roi.height -= 1;
  EXPECT_FALSE(FromCameraInfo(info, &error));
  EXPECT_NE(error.find("camera_info roi"), std::string::npos) << error;
}

TEST(Conversions, BinnedCameraInfoIsRefused) {
  sensor_msgs::CameraInfo info = ToCameraInfo(SomeCamera(), 5, "optical");
  info.binning_x = 2;
  std::string error;
  EXPECT_FALSE(FromCameraInfo(info, &error));
}

TEST(Conversions, TransformsRoundTrip) {
  const Rigid3 b_from_a{Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0), Eigen::Vector3d(1.0, 2.0, 3.0)};
  std::string error;
  const auto back = FromTransform(ToTransform(b_from_a), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_LT((back->translation - b_from_a.translation).norm(), 1e-12);
  EXPECT_LT(back->rotation.angularDistance(b_from_a.rotation), 1e-12);
}

TEST(Conversions, ZeroQuaternionIsRefused) {
  std::string error;
  EXPECT_FALSE(FromTransform(geometry_msgs::Transform(), &error));
}

TEST(Conversions, NamesTheNumberThatNoTransformHas) {
  geometry_msgs::Transform message;
  message.rotation.w = 1.0;
  message.translation.z = std::nan("");
  std::string error;
  EXPECT_FALSE(FromTransform(message, &error));
  EXPECT_EQ(error, "translation.z = nan: expected a finite number");
}

TEST(Conversions, OdometryRoundTripsWithItsCovariance) {
  const OdometrySample sample{1.0, -2.0, -3.0,
                              OdometryCovariance{1, 0.1, 0.2, 0.1, 2, 0.3, 0.2, 0.3, 3}};
  std::string error;
  const auto back = FromOdometry(ToOdometry(sample, 7, "odom", "base_link"), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_DOUBLE_EQ(back->x_m, 1.0);
  EXPECT_DOUBLE_EQ(back->y_m, -2.0);
  EXPECT_NEAR(back->yaw_rad, -3.0, 1e-12);
  EXPECT_EQ(back->covariance, sample.covariance);
}

TEST(Conversions, UnknownOdometryCovarianceStaysUnknown) {
  std::string error;
  for (const size_t diagonal : {0u, 7u, 35u}) {
    nav_msgs::Odometry message = ToOdometry({1.0, 2.0, 0.5}, 7, "odom", "base_link");
    message.pose.covariance.fill(4.0);
    message.pose.covariance[diagonal] = -1.0;
    const auto sample = FromOdometry(message, &error);
    ASSERT_TRUE(sample) << error;
    EXPECT_FALSE(sample->covariance) << diagonal;
  }
  const OdometrySample unknown{1.0, 2.0, 0.5};
  const auto again = FromOdometry(ToOdometry(unknown, 7, "odom", "base_link"), &error);
  ASSERT_TRUE(again) << error;
  EXPECT_FALSE(again->covariance);
  const auto back = FromMessage(ToMessage(unknown), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_FALSE(back->covariance);
}

TEST(Conversions, OdometryWithoutAnyUncertaintyIsNotUnknown) {
  std::string error;
  const auto back =
      FromMessage(ToMessage(OdometrySample{1.0, 2.0, 0.5, OdometryCovariance{}}), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_EQ(back->covariance, OdometryCovariance{});
}

TEST(Conversions, OdometryWithoutOrientationIsRefused) {
  std::string error;
  EXPECT_FALSE(FromOdometry(nav_msgs::Odometry(), &error));
}

TEST(Conversions, OdometryThatIsNotFiniteIsRefused) {
  nav_msgs::Odometry message = ToOdometry({}, 7, "odom", "base_link");
  message.pose.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  std::string error;
  EXPECT_FALSE(FromOdometry(message, &error));
}

TEST(Conversions, FrameIdsRoundTrip) {
  const FrameId id{{"rovio1", 1600000000123456789, 3}, 12};
  std::string error;
  const auto back = FromMessage(ToMessage(id), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_EQ(*back, id);
}

}  // namespace
}  // namespace rovio_sfm
