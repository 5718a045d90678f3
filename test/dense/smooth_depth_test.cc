#include "rovio_sfm/dense/smooth_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rovio_sfm {
namespace {

constexpr float kSigma = 0.05f;  // map units, of an error of one pixel

// A depth map by inverse depth.
MeasuredDepth Measured(const std::function<double(int col, int row)>& inverse) {
  MeasuredDepth measured{DepthMap(60, 80, CV_32F), cv::Mat(60, 80, CV_32F, cv::Scalar(kSigma))};
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 80; ++col) {
      const double value = inverse(col, row);
      measured.depth.at<float>(row, col) = value > 0.0 ? static_cast<float>(1.0 / value) : 0.0f;
    }
  }
  return measured;
}

double Slanted(int col, int row) { return 0.5 + 0.0002 * col - 0.0004 * row; }

// Root mean square of the relative errors of what is known.
double ErrorOf(const DepthMap& depth, const std::function<double(int, int)>& inverse) {
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const double found = depth.at<float>(row, col);
      if (found <= 0.0) continue;
      const double error = found * inverse(col, row) - 1.0;
      sum += error * error, ++count;
    }
  }
  return std::sqrt(sum / count);
}

TEST(SmoothDepth, LeavesAPlaneAsItIs) {
  const MeasuredDepth smooth = SmoothDepth(Measured(Slanted), {});
  EXPECT_EQ(cv::countNonZero(smooth.depth), 60 * 80);
  EXPECT_LT(ErrorOf(smooth.depth, Slanted), 1e-6);
}

TEST(SmoothDepth, TakesNoiseAway) {
  cv::RNG rng(3);
  const MeasuredDepth noisy = Measured([&](int col, int row) {
    return Slanted(col, row) + rng.gaussian(0.25 * kSigma * 0.25);  // a quarter of a pixel
  });
  const MeasuredDepth smooth = SmoothDepth(noisy, {});
  EXPECT_GT(cv::countNonZero(smooth.depth), 0.99 * 60 * 80);
  EXPECT_LT(ErrorOf(smooth.depth, Slanted), 0.25 * ErrorOf(noisy.depth, Slanted));
}

TEST(SmoothDepth, DoesNotMixTwoSurfaces) {
  const auto step = [](int col, int) { return col < 40 ? 0.5 : 0.4; };
  const MeasuredDepth smooth = SmoothDepth(Measured(step), {});
  EXPECT_GT(cv::countNonZero(smooth.depth), 0.99 * 60 * 80);
  EXPECT_LT(ErrorOf(smooth.depth, step), 1e-6);
}

TEST(SmoothDepth, DropsWhatLiesOnNoSurface) {
  // A curtain of three columns from the near surface to the far one, steeper than any fit follows.
  const auto curtain = [](int col, int) {
    return col < 39 ? 0.5 : col > 41 ? 0.2 : 0.5 - 0.075 * (col - 38);
  };
  const MeasuredDepth smooth = SmoothDepth(Measured(curtain), {});
  EXPECT_EQ(cv::countNonZero(smooth.depth.colRange(39, 42)), 0);
  EXPECT_EQ(cv::countNonZero(smooth.depth.colRange(0, 39)), 39 * 60);
}

TEST(SmoothDepth, DropsLonePixels) {
  const MeasuredDepth lone =
      Measured([](int col, int row) { return col % 20 == 0 && row % 20 == 0 ? 0.5 : 0.0; });
  EXPECT_EQ(cv::countNonZero(SmoothDepth(lone, {}).depth), 0);
}

}  // namespace
}  // namespace rovio_sfm
