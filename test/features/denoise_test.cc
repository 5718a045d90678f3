#include "rovio_sfm/features/denoise.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(Denoise, ReducesNoiseAndKeepsAnEdge) {
  cv::Mat image(60, 60, CV_8UC3, cv::Scalar::all(40));
  image.colRange(30, 60).setTo(cv::Scalar::all(220));
  cv::Mat noise(image.size(), CV_16SC3), noisy;
  cv::RNG(1).fill(noise, cv::RNG::NORMAL, 0.0, 10.0);
  cv::add(image, noise, noisy, cv::noArray(), CV_8UC3);
  const cv::Mat result = Denoise(noisy, {});
  EXPECT_LT(cv::norm(result, image, cv::NORM_L2), 0.8 * cv::norm(noisy, image, cv::NORM_L2));
  EXPECT_GT(result.at<cv::Vec3b>(20, 31)[0] - result.at<cv::Vec3b>(20, 28)[0], 120);
}

TEST(Denoise, SwitchedOffGivesTheImageItself) {
  const cv::Mat image(4, 4, CV_8UC3, cv::Scalar::all(40));
  DenoiseOptions options;
  options.enabled = false;
  EXPECT_EQ(Denoise(image, options).data, image.data);
}

TEST(DenoiseOptions, RefusesAnEvenDiameter) {
  DenoiseOptions options;
  options.diameter_px = 4;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "diameter_px = 4: expected an odd number");
}

}  // namespace
}  // namespace rovio_sfm
