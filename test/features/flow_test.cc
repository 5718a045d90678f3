#include "rovio_sfm/features/flow.h"

#include <gtest/gtest.h>

#include "features/test_images.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

cv::Mat Grey(uint64_t seed) {
  cv::Mat grey;
  cv::cvtColor(TexturedImage(320, 240, seed), grey, cv::COLOR_BGR2GRAY);
  return grey;
}

cv::Mat Shifted(const cv::Mat& image, double dx, double dy) {
  cv::Mat result;
  cv::warpAffine(image, result, cv::Matx23d(1, 0, dx, 0, 1, dy), image.size(), cv::INTER_CUBIC,
                 cv::BORDER_REFLECT);
  return result;
}

TEST(TrackPoints, FollowsASubpixelShift) {
  const cv::Mat image = Grey(4);
  const FlowPyramid a = BuildFlowPyramid(image, {});
  const FlowPyramid b = BuildFlowPyramid(Shifted(image, 6.25, -3.5), {});
  const std::vector<cv::Point2f> points = {{100, 100}, {200, 60}, {160, 180}};
  const auto tracked = TrackPoints(a, b, points, {}, {});
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(tracked[i].has_value());
    EXPECT_NEAR(tracked[i]->x - points[i].x, 6.25, 0.1);
    EXPECT_NEAR(tracked[i]->y - points[i].y, -3.5, 0.1);
  }
}

TEST(TrackPoints, LosesWhatLeavesTheImage) {
  const cv::Mat image = Grey(4);
  const FlowPyramid a = BuildFlowPyramid(image, {});
  const FlowPyramid b = BuildFlowPyramid(Shifted(image, 20, 0), {});
  const auto tracked = TrackPoints(a, b, {{310, 120}}, {}, {});
  EXPECT_FALSE(tracked[0].has_value());
}

TEST(TrackPoints, LosesMostPointsBetweenForeignImages) {
  const FlowPyramid a = BuildFlowPyramid(Grey(4), {}), b = BuildFlowPyramid(Grey(5), {});
  std::vector<cv::Point2f> points;
  for (float x = 40; x < 280; x += 20) points.emplace_back(x, 120.0f);
  size_t num_tracked = 0;
  for (const auto& point : TrackPoints(a, b, points, {}, {})) num_tracked += point.has_value();
  EXPECT_LT(num_tracked, points.size() / 3);
}

TEST(TrackPoints, OfNoPointsIsEmpty) {
  const FlowPyramid a = BuildFlowPyramid(Grey(4), {});
  EXPECT_TRUE(TrackPoints(a, a, {}, {}, {}).empty());
}

TEST(FlowOptions, RefusesAnEvenWindow) {
  FlowOptions options;
  options.window_px = 20;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "window_px = 20: expected an odd number");
}

}  // namespace
}  // namespace rovio_sfm
