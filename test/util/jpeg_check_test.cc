#include "rovio_sfm/util/jpeg_check.h"

#include <gtest/gtest.h>

#include "util/jpeg_sample.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMegapixel = 1024 * 1024;

// The sample without bytes `from` to `to` of its size, in hundredths.
std::string WithoutPart(size_t from, size_t to) {
  std::string bytes = JpegSample(320, 240);
  bytes.erase(bytes.size() * from / 100, bytes.size() * (to - from) / 100);
  return bytes;
}

TEST(CheckJpeg, ReadsTheSizeOfAWholeImage) {
  const std::string bytes = JpegSample(640, 480);
  const JpegInfo info = CheckJpeg(bytes, kMegapixel);
  EXPECT_EQ(info.fault, JpegFault::kNone);
  EXPECT_EQ(info.width_px, 640);
  EXPECT_EQ(info.height_px, 480);
  EXPECT_EQ(info.num_bytes, bytes.size());
}

TEST(CheckJpeg, SaysWhereTheImageEndsBeforeOtherBytes) {
  const std::string bytes = JpegSample(64, 48);
  const JpegInfo info = CheckJpeg(bytes + "\r\n\r\nmore", kMegapixel);
  EXPECT_EQ(info.fault, JpegFault::kNone);
  EXPECT_EQ(info.num_bytes, bytes.size());
}

TEST(CheckJpeg, SeesATruncatedImageWhereverItEnds) {
  const std::string whole = JpegSample(64, 48);
  for (size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(CheckJpeg(whole.substr(0, length), kMegapixel).fault, JpegFault::kNone) << length;
  }
  EXPECT_EQ(CheckJpeg(whole.substr(0, whole.size() - 20), kMegapixel).fault, JpegFault::kNoEnd);
}

TEST(CheckJpeg, SeesAnImageThatLostDataAndKeptItsEnd) {
  for (const auto& [from, to] : {std::pair{40, 95}, {70, 72}, {90, 99}}) {
    const std::string bytes = WithoutPart(static_cast<size_t>(from), static_cast<size_t>(to));
    EXPECT_EQ(CheckJpegMarkers(bytes, kMegapixel).fault, JpegFault::kNone) << from;
    EXPECT_EQ(CheckJpeg(bytes, kMegapixel).fault, JpegFault::kDamagedScan) << from;
  }
}

TEST(CheckJpeg, TakesAFewStrayBytesBeforeTheEndMarker) {
  std::string bytes = JpegSample(64, 48);
  bytes.insert(bytes.size() - 2, 3, '\x11');
  EXPECT_EQ(CheckJpeg(bytes, kMegapixel).fault, JpegFault::kNone);
}

TEST(CheckJpeg, RefusesTooManyPixelsFromTheHeaderAlone) {
  const std::string bytes = WithJpegSize(JpegSample(64, 48), 60000, 60000);
  EXPECT_EQ(CheckJpeg(bytes, kMegapixel).fault, JpegFault::kTooManyPixels);
}

TEST(CheckJpeg, RefusesZeroSizesMissingMarkersAndOtherBytes) {
  EXPECT_EQ(CheckJpeg(WithJpegSize(JpegSample(64, 48), 0, 48), kMegapixel).fault,
            JpegFault::kBadSegment);
  EXPECT_EQ(CheckJpeg(std::string(500, 'x'), kMegapixel).fault, JpegFault::kNoStart);
  EXPECT_EQ(CheckJpeg("", kMegapixel).fault, JpegFault::kTooShort);
  EXPECT_EQ(CheckJpeg("\xFF\xD8\xFF\xD9", kMegapixel).fault, JpegFault::kNoFrameHeader);
  std::string no_frame = JpegSample(64, 48);
  no_frame[no_frame.find("\xFF\xC0") + 1] = '\xE5';
  EXPECT_EQ(CheckJpeg(no_frame, kMegapixel).fault, JpegFault::kNoFrameHeader);
}

TEST(CheckJpeg, SurvivesEveryByteChanged) {
  const std::string whole = JpegSample(32, 24);
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
