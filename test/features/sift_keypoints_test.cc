#include "rovio_sfm/features/sift_keypoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/features2d.hpp>
#include <set>
#include <utility>

#include "features/test_images.h"

namespace rovio_sfm {
namespace {

bool HasTwin(const cv::KeyPoint& keypoint, const std::vector<cv::KeyPoint>& others) {
  return std::any_of(others.begin(), others.end(), [&](const cv::KeyPoint& other) {
    return cv::norm(keypoint.pt - other.pt) < 0.02 &&
           std::abs(keypoint.size - other.size) < 0.01f * keypoint.size;
  });
}

// OpenCV's lie 0.25 px too far right and down: it doubles the image without moving the grid.
std::vector<cv::KeyPoint> OpenCvKeypoints(const cv::Mat& grey) {
  std::vector<cv::KeyPoint> keypoints;
  cv::SIFT::create(0, 3, 0.02, 10.0, 1.6)->detect(grey, keypoints);
  for (cv::KeyPoint& keypoint : keypoints) keypoint.pt -= cv::Point2f(0.25f, 0.25f);
  return keypoints;
}

TEST(FindSiftKeypoints, FindsWhatOpenCvFinds) {
  const auto ours =
      FindSiftKeypoints(BuildSiftOctaves(TexturedGrey(320, 240, 3), true), {0.02, 10.0});
  const auto theirs = OpenCvKeypoints(TexturedGrey(320, 240, 3));
  ASSERT_GT(ours.size(), 100u);
  const auto twins = [](const auto& some, const auto& others) {
    return std::count_if(some.begin(), some.end(),
                         [&](const cv::KeyPoint& k) { return HasTwin(k, others); });
  };
  EXPECT_GE(twins(ours, theirs), 0.98 * static_cast<double>(ours.size()));
  EXPECT_GE(twins(theirs, ours), 0.98 * static_cast<double>(theirs.size()));
}

TEST(FindSiftKeypoints, TellsTheScaleOfABlob) {
  cv::Mat blob(200, 200, CV_8U);
  for (int y = 0; y < blob.rows; ++y) {
    for (int x = 0; x < blob.cols; ++x) {
      const double r2 = (x - 90.0) * (x - 90.0) + (y - 110.0) * (y - 110.0);
      blob.at<uint8_t>(y, x) = cv::saturate_cast<uint8_t>(40.0 + 150.0 * std::exp(-r2 / 128.0));
    }
  }
  for (const bool upsample : {false, true}) {
    const auto keypoints = FindSiftKeypoints(BuildSiftOctaves(blob, upsample), {0.04, 10.0});
    ASSERT_EQ(keypoints.size(), 1u);
    EXPECT_NEAR(keypoints[0].pt.x, 90.0f, 0.05f);
    EXPECT_NEAR(keypoints[0].pt.y, 110.0f, 0.05f);
    EXPECT_NEAR(keypoints[0].size, 2.0f * 8.0f / 1.12f, 1.5f);  // DoG of 2^(1/3) apart
  }
}

TEST(FindSiftKeypoints, FindsNothingInAPlainImage) {
  const cv::Mat plain(100, 100, CV_8U, cv::Scalar(120));
  EXPECT_TRUE(FindSiftKeypoints(BuildSiftOctaves(plain, true), {}).empty());
}

TEST(FindSiftKeypoints, LeavesEdgesOut) {
  cv::Mat edge(100, 100, CV_8U, cv::Scalar(40));
  edge.colRange(50, 100).setTo(200);
  EXPECT_TRUE(FindSiftKeypoints(BuildSiftOctaves(edge, true), {0.02, 10.0}).empty());
}

// Squares of 20 px: their corners lie at 20 k - 0.5.
cv::Mat Checkerboard() {
  cv::Mat board(120, 160, CV_8U, cv::Scalar(60));
  for (int y = 0; y < board.rows; ++y) {
    for (int x = 0; x < board.cols; ++x) {
      if ((x / 20 + y / 20) % 2 == 0) board.at<uint8_t>(y, x) = 190;
    }
  }
  return board;
}

constexpr size_t kNumInnerCorners = 7 * 5;

class FindCornersTest : public testing::Test {
 protected:
  const std::vector<SiftOctave> octaves_ = BuildSiftOctaves(Checkerboard(), true);
};

TEST_F(FindCornersTest, FindsEachCornerExactly) {
  const auto corners = FindCorners(octaves_.front(), 2.0);
  std::set<std::pair<float, float>> inner;
  for (const cv::KeyPoint& corner : corners) {
    const float column = std::round((corner.pt.x + 0.5f) / 20.0f);
    const float row = std::round((corner.pt.y + 0.5f) / 20.0f);
    if (column < 1.0f || column > 7.0f || row < 1.0f || row > 5.0f) continue;
    EXPECT_NEAR(corner.pt.x, 20.0f * column - 0.5f, 0.05f);
    EXPECT_NEAR(corner.pt.y, 20.0f * row - 0.5f, 0.05f);
    inner.emplace(column, row);
  }
  EXPECT_EQ(inner.size(), kNumInnerCorners);
}

TEST_F(FindCornersTest, FindsNothingOnPlainSurfacesAndEdges) {
  cv::Mat picture(100, 100, CV_8U, cv::Scalar(120));
  EXPECT_TRUE(FindCorners(BuildSiftOctaves(picture, true).front(), 2.0).empty());
  picture.colRange(50, 100).setTo(200);
  EXPECT_TRUE(FindCorners(BuildSiftOctaves(picture, true).front(), 2.0).empty());
}

}  // namespace
}  // namespace rovio_sfm
