#include "rovio_sfm/tools/second_look.h"

#include <gtest/gtest.h>

#include "features/test_images.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

double MeanDifference(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  const cv::Scalar mean = cv::mean(difference);
  return (mean[0] + mean[1] + mean[2]) / 3.0;
}

SecondLookOptions NoChange() { return {0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1}; }

TEST(TakeSecondLook, IsTheImageItselfWithoutChange) {
  const cv::Mat image = TexturedImage(160, 120, 1);
  Rng rng(1);
  EXPECT_EQ(MeanDifference(TakeSecondLook(image, NoChange(), &rng), image), 0.0);
}

TEST(TakeSecondLook, AddsNoiseOfTheGivenSpread) {
  const cv::Mat image(120, 160, CV_8UC3, cv::Scalar::all(128));
  SecondLookOptions options = NoChange();
  options.noise_sigma = 10.0;
  Rng rng(2);
  EXPECT_NEAR(MeanDifference(TakeSecondLook(image, options, &rng), image), 7.98, 0.2);
}

TEST(TakeSecondLook, MovesTheView) {
  const cv::Mat image = TexturedImage(160, 120, 3);
  SecondLookOptions options;
  options.noise_sigma = 0.0;
  options.max_gain = 1.0;
  Rng rng(3);
  const cv::Mat look = TakeSecondLook(image, options, &rng);
  EXPECT_EQ(look.size(), image.size());
  EXPECT_GT(MeanDifference(look, image), 5.0);
}

TEST(TakeSecondLook, DependsOnTheSeedOnly) {
  const cv::Mat image = TexturedImage(160, 120, 4);
  Rng first(7), again(7), other(8);
  const cv::Mat look = TakeSecondLook(image, {}, &first);
  EXPECT_EQ(MeanDifference(look, TakeSecondLook(image, {}, &again)), 0.0);
  EXPECT_GT(MeanDifference(look, TakeSecondLook(image, {}, &other)), 1.0);
}

TEST(SecondLookOptions, NamesWhatDoesNotFit) {
  std::string error;
  EXPECT_TRUE(IsValid(SecondLookOptions{}, &error));
  SecondLookOptions options;
  options.max_zoom = 0.5;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "max_zoom = 0.5: expected 1 to 4");
}

}  // namespace
}  // namespace rovio_sfm
