#include "rovio_sfm/rovio/jpeg_check.h"

#include <gtest/gtest.h>

#include "rovio/jpeg_sample.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMegapixel = 1024 * 1024;

TEST(CheckJpeg, ReadsTheSizeOfAWholeImage) {
  const JpegInfo info = CheckJpeg(JpegSample(640, 480), kMegapixel);
  EXPECT_EQ(info.fault, JpegFault::kNone);
  EXPECT_EQ(info.width_px, 640);
  EXPECT_EQ(info.height_px, 480);
}

TEST(CheckJpeg, AllowsLineEndsBehindTheImage) {
  EXPECT_EQ(CheckJpeg(JpegSample(640, 480) + "\r\n\r\n", kMegapixel).fault, JpegFault::kNone);
}

TEST(CheckJpeg, SeesATruncatedImageWhereverItEnds) {
  const std::string whole = JpegSample(640, 480);
  for (size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(CheckJpeg(whole.substr(0, length), kMegapixel).fault, JpegFault::kNone) << length;
  }
  EXPECT_EQ(CheckJpeg(whole.substr(0, whole.size() - 20), kMegapixel).fault, JpegFault::kNoEnd);
}

TEST(CheckJpeg, RefusesTooManyPixelsFromTheHeaderAlone) {
  EXPECT_EQ(CheckJpeg(JpegSample(60000, 60000), kMegapixel).fault, JpegFault::kTooManyPixels);
}

TEST(CheckJpeg, RefusesZeroSizesMissingMarkersAndOtherBytes) {
  EXPECT_EQ(CheckJpeg(JpegSample(0, 480), kMegapixel).fault, JpegFault::kBadSegment);
  EXPECT_EQ(CheckJpeg(std::string(500, 'x'), kMegapixel).fault, JpegFault::kNoStart);
  EXPECT_EQ(CheckJpeg("", kMegapixel).fault, JpegFault::kTooShort);
  std::string no_frame = JpegSample(640, 480);
  no_frame[no_frame.find("\xFF\xC0") + 1] = '\xE5';
  EXPECT_EQ(CheckJpeg(no_frame, kMegapixel).fault, JpegFault::kNoFrameHeader);
}

TEST(CheckJpeg, SurvivesEveryByteChanged) {
  const std::string whole = JpegSample(320, 240);
  for (size_t i = 0; i < whole.size(); ++i) {
    for (const char value : {'\x00', '\xFF', '\xD8', '\xDA', '\xC0'}) {
      std::string changed = whole;
      changed[i] = value;
      CheckJpeg(changed, kMegapixel);
    }
  }
}

}  // namespace
}  // namespace rovio_sfm
