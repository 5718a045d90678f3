#include "rovio_sfm/sim/world/render_image.h"

#include <gtest/gtest.h>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

class ImageRenderers : public testing::Test {
 protected:
  static CameraMotion LookAhead(double sway_rad) {
    Eigen::Matrix3d rotation;
    rotation << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    const Eigen::Quaterniond level(rotation);
    const Eigen::AngleAxisd sway(sway_rad, Eigen::Vector3d::UnitY());
    return {{level, {0.8, 1.2, 0.28}}, {level * sway, {0.8, 1.2, 0.28}}};
  }

  const World world_{SmallWorldSpec()};
  const ImageRenderer renderer_{world_, SmallCamera(), {}};
};

TEST_F(ImageRenderers, GivesTheSameBytesForTheSameSeed) {
  const cv::Mat a = renderer_.Render(LookAhead(0.0), 4), b = renderer_.Render(LookAhead(0.0), 4);
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(a, renderer_.Render(LookAhead(0.0), 5), cv::NORM_INF), 0.0);
}

TEST_F(ImageRenderers, SeesLightEverywhereInAClosedRoom) {
  cv::Mat channel;
  cv::extractChannel(renderer_.Render(LookAhead(0.0), 1), channel, 1);
  EXPECT_GT(cv::countNonZero(channel > 1e-6), 0.99 * 64 * 48);  // the rest is black ink
}

TEST_F(ImageRenderers, BlursWhenTheCameraTurns) {
  const cv::Mat sharp = renderer_.Render(LookAhead(0.0), 1);
  const cv::Mat blurred = renderer_.Render(LookAhead(0.3), 1);
  cv::Scalar mean, sharp_spread, blurred_spread;
  cv::meanStdDev(sharp.colRange(1, 64) - sharp.colRange(0, 63), mean, sharp_spread);
  cv::meanStdDev(blurred.colRange(1, 64) - blurred.colRange(0, 63), mean, blurred_spread);
  EXPECT_LT(blurred_spread[0], sharp_spread[0]);
}

TEST_F(ImageRenderers, RollingShutterShowsTheFirstRowEarly) {
  RenderOptions options;
  options.rolling_share = 0.9;
  const ImageRenderer rolling(world_, SmallCamera(), options);
  const cv::Mat moved = rolling.Render(LookAhead(0.3), 1);
  const cv::Mat still = renderer_.Render(LookAhead(0.0), 1);
  EXPECT_LT(cv::norm(moved.row(0), still.row(0)), cv::norm(moved.row(47), still.row(47)));
}

TEST_F(ImageRenderers, GuestsHideWhatIsBehindThemAndAreHiddenThemselves) {
  WorldSpec spec = SmallWorldSpec();
  spec.objects = {spec.objects[1]};  // a crate
  spec.objects[0].world_from_object = {Rigid3()};
  const World crate(spec);
  const auto differing = [&](const Eigen::Vector3d& at_m) {
    const std::vector<PlacedWorld> guests{{&crate, {Eigen::Quaterniond::Identity(), at_m}}};
    cv::Mat difference;
    cv::absdiff(renderer_.Render(LookAhead(0.0), 1, guests), renderer_.Render(LookAhead(0.0), 1),
                difference);
    return cv::countNonZero(difference.reshape(1) > 0.0);
  };
  EXPECT_GT(differing({1.6, 1.2, 0.0}), 500);
  EXPECT_EQ(differing({3.6, 1.2, 0.0}), 0);   // behind the wall
  EXPECT_EQ(differing({-0.9, 1.2, 0.0}), 0);  // behind the camera
}

TEST_F(ImageRenderers, DepthIsAlongTheOpticalAxis) {
  const cv::Mat depth =
      RenderDepth(world_, SmallCamera(), LookAhead(0.0).world_from_camera_open, 4);
  EXPECT_EQ(depth.size(), cv::Size(16, 12));
  EXPECT_NEAR(depth.at<float>(0, 15), 2.2f, 0.01f);  // the wall at x = 3, at the picture's edge
}

TEST(RenderOptions, RefusesNoSamples) {
  RenderOptions options;
  options.samples_per_side = 0;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("samples_per_side"), std::string::npos);
}

TEST(PoseAt, MeetsBothEnds) {
  CameraMotion motion;
  motion.world_from_camera_close.translation = {1.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(PoseAt(motion, 0.0).translation.x(), 0.0);
  EXPECT_DOUBLE_EQ(PoseAt(motion, 0.25).translation.x(), 0.25);
}

}  // namespace
}  // namespace rovio_sfm::sim
