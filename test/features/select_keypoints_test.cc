#include "rovio_sfm/features/select_keypoints.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

cv::KeyPoint At(float x, float y, float response, float angle = 0.0f) {
  return cv::KeyPoint(x, y, 3.0f, angle, response);
}

TEST(SelectKeypoints, TakesFromEachCellBeforeTheSecondOfAny) {
  SelectOptions options;
  options.max_keypoints = 2;
  const std::vector<cv::KeyPoint> chosen =
      SelectKeypoints({At(10, 10, 9), At(20, 20, 8), At(150, 150, 1)}, cv::Size(200, 200), options);
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0].pt, cv::Point2f(10, 10));
  EXPECT_EQ(chosen[1].pt, cv::Point2f(150, 150));
}

TEST(SelectKeypoints, KeepsTheStrongerOfTwoNearOnes) {
  const std::vector<cv::KeyPoint> chosen =
      SelectKeypoints({At(10, 10, 1), At(10.5f, 10, 2)}, cv::Size(200, 200), {});
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen[0].response, 2.0f);
}

TEST(SelectKeypoints, MeasuresStrengthBySizeTooWhereAsked) {
  cv::KeyPoint large = At(150, 150, 5);
  large.size = 16 * large.size;
  SelectOptions options;
  options.max_keypoints = 1;
  options.max_candidates = 1;
  const auto first_of = [&](double exponent) {
    options.size_exponent = exponent;
    return SelectKeypoints({At(10, 10, 9), large}, cv::Size(200, 200), options).front().response;
  };
  EXPECT_EQ(first_of(0.0), 9.0f);
  EXPECT_EQ(first_of(0.2), 9.0f);   // 5 · 16^0.2 = 8.7
  EXPECT_EQ(first_of(0.25), 5.0f);  // 10
}

TEST(SelectKeypoints, KeepsOneOrientationOfAPlaceWhateverTheOrder) {
  const std::vector<cv::KeyPoint> one =
      SelectKeypoints({At(10, 10, 1, 200), At(10, 10, 1, 40)}, cv::Size(200, 200), {});
  const std::vector<cv::KeyPoint> other =
      SelectKeypoints({At(10, 10, 1, 40), At(10, 10, 1, 200)}, cv::Size(200, 200), {});
  ASSERT_EQ(one.size(), 1u);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_EQ(one[0].angle, 40.0f);
  EXPECT_EQ(other[0].angle, 40.0f);
}

TEST(SelectKeypoints, DropsTheBorderAndOrdersByRowThenColumn) {
  const std::vector<cv::KeyPoint> chosen = SelectKeypoints(
      {At(1, 50, 9), At(90, 60, 1), At(80, 30, 2), At(40, 30, 3)}, cv::Size(200, 200), {});
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_EQ(chosen[0].pt, cv::Point2f(40, 30));
  EXPECT_EQ(chosen[1].pt, cv::Point2f(80, 30));
  EXPECT_EQ(chosen[2].pt, cv::Point2f(90, 60));
}

TEST(SelectKeypoints, SpreadsOnlyTheStrongestCandidates) {
  SelectOptions options;
  options.max_candidates = 2;
  const std::vector<cv::KeyPoint> chosen =
      SelectKeypoints({At(10, 10, 9), At(20, 20, 8), At(150, 150, 1)}, cv::Size(200, 200), options);
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[1].pt, cv::Point2f(20, 20));
}

TEST(FillWith, TakesInOrderWhatLiesApartUntilItIsFull) {
  SelectOptions options;
  options.max_keypoints = 4;
  std::vector<cv::KeyPoint> keypoints = {At(50, 50, 1)};
  FillWith({At(51, 50, 9), At(1, 50, 9), At(80, 50, 1), At(80.5f, 50, 5), At(90, 50, 1),
            At(10, 10, 1), At(20, 20, 1)},
           cv::Size(200, 200), options, &keypoints);
  ASSERT_EQ(keypoints.size(), 4u);
  EXPECT_EQ(keypoints[0].pt, cv::Point2f(50, 50));
  EXPECT_EQ(keypoints[1].pt, cv::Point2f(80, 50));
  EXPECT_EQ(keypoints[2].pt, cv::Point2f(90, 50));
  EXPECT_EQ(keypoints[3].pt, cv::Point2f(10, 10));
}

TEST(SelectKeypoints, OfNoneIsNone) {
  EXPECT_TRUE(SelectKeypoints({}, cv::Size(200, 200), {}).empty());
}

}  // namespace
}  // namespace rovio_sfm
