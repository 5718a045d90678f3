#include "rovio_sfm/frontend/light_tracks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "frontend/moving_images.h"
#include "rovio_sfm/features/extract_features.h"

namespace rovio_sfm {
namespace {

class LightTracksTest : public testing::Test {
 protected:
  void SetUp() override {
    ExtractOptions extract;
    extract.max_features = 300;
    features_ = std::make_shared<const FrameFeatures>(
        ExtractFeatures(images_.At(0), MovingImages::TheCamera(), extract));
    for (size_t i = 0; i < features_->keypoints.size(); ++i) tracks_.push_back(100 + i);
  }

  static FlowPyramid Pyramid(const cv::Mat& image) {
    cv::Mat grey;
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    return BuildFlowPyramid(grey, {});
  }

  LightFeatures FollowTo(double last_shift_px) {
    LightTracks light(options_);
    light.StartFrom(Pyramid(images_.At(0)), features_, tracks_,
                    std::vector<bool>(tracks_.size(), false));
    LightFeatures result;
    for (double shift = 3.0; shift <= last_shift_px; shift += 3.0) {
      result = light.Follow(Pyramid(images_.At(shift)), MovingImages::TheCamera());
    }
    return result;
  }

  LightOptions options_;
  MovingImages images_;
  std::shared_ptr<const FrameFeatures> features_;
  std::vector<TrackId> tracks_;
};

TEST_F(LightTracksTest, FollowsThroughSeveralImagesWithoutDrift) {
  const LightFeatures light = FollowTo(15.0);
  ASSERT_GT(light.tracks.size(), 100u);
  EXPECT_EQ(light.features.keypoints.size(), light.tracks.size());
  EXPECT_EQ(light.features.colors.size(), light.tracks.size());
  size_t num_right = 0;
  for (size_t i = 0; i < light.tracks.size(); ++i) {
    const Keypoint& from = features_->keypoints[light.tracks[i] - 100];
    const Keypoint& to = light.features.keypoints[i];
    const double expected = from.y_px > 120.0f ? 30.0 : 15.0;
    num_right +=
        std::abs(to.x_px + expected - from.x_px) < 0.15 && std::abs(to.y_px - from.y_px) < 0.15;
  }
  EXPECT_GT(num_right, light.tracks.size() * 8 / 10);
}

TEST_F(LightTracksTest, StaysWithinItsBudget) {
  options_.max_features = 40;
  EXPECT_LE(FollowTo(3.0).tracks.size(), 40u);
}

TEST_F(LightTracksTest, FindsNothingInABlackImage) {
  LightTracks light(options_);
  light.StartFrom(Pyramid(images_.At(0)), features_, tracks_,
                  std::vector<bool>(tracks_.size(), false));
  const cv::Mat black(240, 320, CV_8UC3, cv::Scalar::all(0));
  EXPECT_TRUE(light.Follow(Pyramid(black), MovingImages::TheCamera()).tracks.empty());
}

}  // namespace
}  // namespace rovio_sfm
