#include "rovio_sfm/frontend/prepare_image.h"

#include <gtest/gtest.h>

#include "frontend/moving_images.h"

namespace rovio_sfm {
namespace {

TEST(PrepareImage, ExtractsAheadOnlyInModeEvery) {
  const ImageEvent event = MovingImages::Event(MovingImages().At(0), 0);
  FrontendOptions options;
  EXPECT_NE(PrepareImage(event, options).features, nullptr);
  options.choose.mode = KeyframeMode::kParallax;
  const PreparedImage prepared = PrepareImage(event, options);
  EXPECT_EQ(prepared.features, nullptr);
  EXPECT_EQ(prepared.full.size, cv::Size(320, 240));
  EXPECT_EQ(prepared.small.size, cv::Size(160, 120));
  EXPECT_GT(prepared.sharpness, 0.0);
}

TEST(PrepareImage, RefusesABadCameraMissingDataAndAForeignSize) {
  const ImageEvent good = MovingImages::Event(MovingImages().At(0), 0);
  ImageEvent bad = good;
  bad.camera.fx = 0.0;
  EXPECT_NE(PrepareImage(bad, {}).refusal, "");
  bad = good;
  bad.encoded = nullptr;
  EXPECT_EQ(PrepareImage(bad, {}).refusal, "no image data");
  bad = good;
  bad.camera.width = 640;
  EXPECT_EQ(PrepareImage(bad, {}).refusal, "image of 320x240 px: expected the camera's 640x240");
}

}  // namespace
}  // namespace rovio_sfm
