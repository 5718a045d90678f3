#include "rovio_sfm/frontend/choose_keyframe.h"

#include <gtest/gtest.h>

#include "frontend/moving_images.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr ImageMotion kStill = {0.0, 0.0, 1.0};

ChooseOptions Video() {
  ChooseOptions options;
  options.mode = KeyframeMode::kParallax;
  return options;
}

FlowPyramid Small(const cv::Mat& image) {
  cv::Mat grey, small;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::resize(grey, small, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  return BuildFlowPyramid(small, MotionTracker::PyramidOptions());
}

TEST(ChooseImage, TakesAKeyframeByFlowRotationOrLostOverlap) {
  EXPECT_EQ(ChooseImage(kStill, 1.0, 0, Video()), ImageChoice::kLight);
  EXPECT_EQ(ChooseImage({0.03, 0.0, 1.0}, 1.0, 0, Video()), ImageChoice::kKeyframe);
  EXPECT_EQ(ChooseImage({0.0, 0.2, 1.0}, 1.0, 0, Video()), ImageChoice::kKeyframe);
  EXPECT_EQ(ChooseImage({0.0, 0.0, 0.3}, 1.0, 0, Video()), ImageChoice::kKeyframe);
}

TEST(ChooseImage, PutsABlurredKeyframeOffButNotForEver) {
  EXPECT_EQ(ChooseImage({0.03, 0.0, 1.0}, 0.5, 0, Video()), ImageChoice::kLight);
  EXPECT_EQ(ChooseImage({0.03, 0.0, 1.0}, 0.5, 8, Video()), ImageChoice::kKeyframe);
}

TEST(ChooseImage, DropsSpoiltImagesInBothModes) {
  EXPECT_EQ(ChooseImage(kStill, 0.1, 99, Video()), ImageChoice::kSpoilt);
  EXPECT_EQ(ChooseImage(kStill, 0.1, 99, {}), ImageChoice::kSpoilt);
}

TEST(MotionTracker, SeesParallaxButNoFlowInAPureRotation) {
  const MovingImages images;
  MotionTracker tracker(Video());
  tracker.StartFrom(Small(images.At(0)));
  const ImageMotion moved = tracker.Follow(Small(images.At(8)), MovingImages::TheCamera());
  EXPECT_GT(moved.flow_rad, 0.01);
  EXPECT_GT(moved.tracked_share, 0.5);

  // A turn by 0.03 rad, as the homography of the image.
  const cv::Matx33d k(256, 0, 160, 0, 256, 120, 0, 0, 1);
  const cv::Matx33d turn(cos(0.03), 0, sin(0.03), 0, 1, 0, -sin(0.03), 0, cos(0.03));
  cv::Mat turned;
  cv::warpPerspective(images.At(0), turned, k * turn * k.inv(), cv::Size(320, 240));
  tracker.StartFrom(Small(images.At(0)));
  const ImageMotion rotated = tracker.Follow(Small(turned), MovingImages::TheCamera());
  EXPECT_NEAR(rotated.rotation_rad, 0.03, 0.003);
  EXPECT_LT(rotated.flow_rad, 0.002);
}

TEST(MotionTracker, CallsEverythingLostInABlackImage) {
  MotionTracker tracker(Video());
  tracker.StartFrom(Small(MovingImages().At(0)));
  const cv::Mat black(240, 320, CV_8UC3, cv::Scalar::all(0));
  EXPECT_EQ(tracker.Follow(Small(black), MovingImages::TheCamera()).tracked_share, 0.0);
}

TEST(KeyframeChooser, BeginsWithTheFirstImageUnlessItIsBlack) {
  KeyframeChooser chooser(Video());
  const FlowPyramid image = Small(MovingImages().At(0));
  EXPECT_EQ(chooser.Choose(image, 0.0, MovingImages::TheCamera()), ImageChoice::kSpoilt);
  EXPECT_EQ(chooser.Choose(image, 9.0, MovingImages::TheCamera()), ImageChoice::kKeyframe);
}

TEST(ChooseOptions, NamesTheBadOption) {
  ChooseOptions options;
  options.spoilt_share = 0.9;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "spoilt_share = 0.9: expected at most blurred_share");
}

}  // namespace
}  // namespace rovio_sfm
