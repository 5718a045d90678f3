#include "rovio_sfm/sim/world/draw_texture.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TextureSpec Spec() {
  TextureSpec spec;
  spec.name = "test";
  spec.seed = 7;
  spec.width_px = 128;
  spec.height_px = 96;
  spec.contrast = 0.5;
  return spec;
}

TEST(DrawTexture, HasTheAskedSizeAndIsReproducible) {
  TextureSpec spec = Spec();
  spec.marks = {"text", "chips"};
  const cv::Mat first = DrawTexture(spec), second = DrawTexture(spec);
  EXPECT_EQ(first.size(), cv::Size(128, 96));
  EXPECT_EQ(cv::norm(first, second, cv::NORM_INF), 0.0);
}

TEST(DrawTexture, StaysPlainWithoutContrast) {
  TextureSpec spec = Spec();
  spec.contrast = 0.0;
  cv::Scalar mean, deviation;
  cv::meanStdDev(DrawTexture(spec), mean, deviation);
  EXPECT_EQ(deviation[0], 0.0);
}

TEST(DrawTexture, CoversTheAskedShareWithPatches) {
  TextureSpec spec = Spec();
  spec.contrast = 0.0;
  spec.color = {200, 200, 200};
  spec.accent = {0, 0, 0};
  spec.patches = 0.5;
  cv::Mat grey;
  cv::extractChannel(DrawTexture(spec), grey, 0);
  const double dark = cv::countNonZero(grey < 60) / (128.0 * 96.0);
  EXPECT_NEAR(dark, 0.5, 0.12);
}

}  // namespace
}  // namespace rovio_sfm::sim
