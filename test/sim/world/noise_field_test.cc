#include "rovio_sfm/sim/world/noise_field.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(MakeNoiseField, HasAboutUnitSpreadAndNoMean) {
  Rng rng(1);
  const cv::Mat field = MakeNoiseField({400, 300}, {}, rng);
  cv::Scalar mean, deviation;
  cv::meanStdDev(field, mean, deviation);
  EXPECT_NEAR(mean[0], 0.0, 0.6);
  EXPECT_NEAR(deviation[0], 1.0, 0.4);
}

TEST(MakeNoiseField, IsTheSameForTheSameSeed) {
  Rng first(5), second(5);
  const cv::Mat a = MakeNoiseField({64, 64}, {}, first);
  const cv::Mat b = MakeNoiseField({64, 64}, {}, second);
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0);
}

TEST(MakeNoiseField, IsFlatWithoutOctaves) {
  Rng rng(1);
  NoiseFieldOptions options;
  options.coarsest_px = 1.0;
  EXPECT_EQ(cv::countNonZero(MakeNoiseField({32, 16}, options, rng)), 0);
}

}  // namespace
}  // namespace rovio_sfm::sim
