#include "rovio_sfm/features/decode_image.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "features/test_images.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kManyPixels = 32'000'000;

std::vector<uint8_t> Encode(const char* extension) {
  std::vector<uint8_t> bytes;
  cv::imencode(extension, TexturedImage(64, 48, 1), bytes);
  return bytes;
}

TEST(DecodeImage, ReadsJpegAndPng) {
  for (const char* extension : {".jpg", ".png"}) {
    const DecodeResult result = DecodeImage(Encode(extension), kManyPixels);
    EXPECT_EQ(result.reason, "");
    EXPECT_EQ(result.bgr.size(), cv::Size(64, 48));
    EXPECT_EQ(result.bgr.type(), CV_8UC3);
  }
}

// A sensor of 12 bits in words of 16.
TEST(DecodeImage, StretchesWhatFillsTheLowerBitsOfSixteen) {
  const cv::Mat eight = TexturedImage(64, 48, 1);
  cv::Mat twelve;
  eight.convertTo(twelve, CV_16U, 16.0);
  twelve.at<cv::Vec3w>(0, 0) = {4095, 4095, 4095};
  std::vector<uint8_t> bytes;
  cv::imencode(".png", twelve, bytes);
  const cv::Mat bgr = DecodeImage(bytes, kManyPixels).bgr;
  ASSERT_EQ(bgr.type(), CV_8UC3);
  EXPECT_LE(cv::norm(bgr.rowRange(1, 48), eight.rowRange(1, 48), cv::NORM_INF), 1.0);
}

TEST(DecodeImage, RefusesByTheHeaderAlone) {
  for (const char* extension : {".jpg", ".png"}) {
    EXPECT_EQ(DecodeImage(Encode(extension), 64 * 48 - 1).reason,
              "image of 64x48 px: expected at most 3071 pixels");
  }
}

TEST(DecodeImage, RefusesATruncatedJpeg) {
  std::vector<uint8_t> bytes = Encode(".jpg");
  bytes.resize(bytes.size() / 2);
  EXPECT_EQ(DecodeImage(bytes, kManyPixels).reason, "JPEG truncated: no end marker");
}

TEST(DecodeImage, RefusesAJpegThatLostDataAndKeptItsEnd) {
  std::vector<uint8_t> bytes = Encode(".jpg");
  bytes.erase(bytes.end() - 400, bytes.end() - 2);
  EXPECT_EQ(DecodeImage(bytes, kManyPixels).reason,
            "JPEG damaged: image data are missing or wrong");
}

TEST(DecodeImage, TakesJunkAfterTheEndMarker) {
  std::vector<uint8_t> bytes = Encode(".jpg");
  bytes.insert(bytes.end(), 20, 0x0d);
  EXPECT_FALSE(DecodeImage(bytes, kManyPixels).bgr.empty());
}

TEST(DecodeImage, NeverCrashesOnCutOrFlippedBytes) {
  for (const char* extension : {".jpg", ".png"}) {
    const std::vector<uint8_t> whole = Encode(extension);
    for (size_t length = 0; length < 64; ++length) {
      DecodeImage({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}, 10000);
    }
    cv::RNG rng(7);
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<uint8_t> bytes = whole;
      bytes[rng.next() % bytes.size()] = static_cast<uint8_t>(rng.next());
      DecodeImage(bytes, 10000);
    }
  }
}

TEST(DecodeImage, RefusesOtherBytes) {
  EXPECT_FALSE(DecodeImage({}, kManyPixels).reason.empty());
  EXPECT_FALSE(DecodeImage(std::vector<uint8_t>(100, 0xff), kManyPixels).reason.empty());
  EXPECT_FALSE(DecodeImage({'B', 'M', 1, 2, 3, 4, 5, 6}, kManyPixels).reason.empty());
}

TEST(EncodedImageSize, RefusesZeroSizes) {
  std::vector<uint8_t> png = Encode(".png");
  for (size_t i = 16; i < 20; ++i) png[i] = 0;
  EXPECT_FALSE(EncodedImageSize(png).has_value());
}

}  // namespace
}  // namespace rovio_sfm
