#include "rovio_sfm/app/thumbnail.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "rovio_sfm/features/decode_image.h"

namespace rovio_sfm {
namespace {

std::vector<uint8_t> Picture(int width, int height, const char* kind) {
  std::vector<uint8_t> bytes;
  cv::imencode(kind, cv::Mat(height, width, CV_8UC3, cv::Scalar(200, 100, 50)), bytes);
  return bytes;
}

ImageSize SizeOf(const std::string& jpeg) {
  return EncodedImageSize({jpeg.begin(), jpeg.end()}).value_or(ImageSize());
}

TEST(ThumbnailOf, IsASmallJpegOfTheSameShape) {
  std::string error;
  for (const char* kind : {".jpg", ".png"}) {
    const auto jpeg = ThumbnailOf(Picture(640, 480, kind), 320, &error);
    ASSERT_TRUE(jpeg) << error;
    EXPECT_EQ(jpeg->substr(0, 2), "\xff\xd8");
    EXPECT_EQ(SizeOf(*jpeg).width, 320);
    EXPECT_EQ(SizeOf(*jpeg).height, 240);
  }
}

TEST(ThumbnailOf, NeverGrowsAPicture) {
  std::string error;
  EXPECT_EQ(SizeOf(*ThumbnailOf(Picture(40, 30, ".png"), 320, &error)).width, 40);
  EXPECT_EQ(SizeOf(*ThumbnailOf(Picture(4000, 1, ".png"), 320, &error)).height, 1);
}

TEST(ThumbnailOf, SaysWhyThereIsNone) {
  std::string error;
  EXPECT_FALSE(ThumbnailOf({1, 2, 3, 4}, 320, &error));
  EXPECT_FALSE(error.empty());
}

}  // namespace
}  // namespace rovio_sfm
