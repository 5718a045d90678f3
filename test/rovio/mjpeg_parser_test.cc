#include "rovio_sfm/rovio/mjpeg_parser.h"

#include <gtest/gtest.h>

#include <vector>

#include "rovio_sfm/util/rng.h"
#include "util/jpeg_sample.h"

namespace rovio_sfm {
namespace {

constexpr char kPartHeader[] = "--WINBONDBOUDARY\r\nContent-Type: image/jpeg\r\n\r\n";

struct Parsed {
  std::vector<MjpegPart> parts;
  MjpegFault fault = MjpegFault::kNone;
  uint64_t num_skipped = 0;
};

// Feeds the bytes in pieces of this size, the first at 1 ns, the next at 2 ns, …
Parsed Parse(const std::string& bytes, size_t piece, const MjpegParserOptions& options = {}) {
  Parsed parsed;
  MjpegParser parser("WINBONDBOUDARY", options,
                     [&parsed](MjpegPart part) { parsed.parts.push_back(std::move(part)); });
  int64_t stamp_ns = 0;
  for (size_t at = 0; at < bytes.size(); at += piece) {
    if (!parser.Feed(bytes.substr(at, piece), ++stamp_ns)) break;
  }
  parsed.fault = parser.Fault();
  parsed.num_skipped = parser.NumSkippedParts();
  return parsed;
}

TEST(BoundaryOf, ReadsTheRobotsAndOtherSpellings) {
  EXPECT_EQ(BoundaryOf("multipart/x-mixed-replace;boundary=WINBONDBOUDARY"), "WINBONDBOUDARY");
  EXPECT_EQ(BoundaryOf("Multipart/X-Mixed-Replace; a=b; Boundary=\"--frame\""), "frame");
  EXPECT_EQ(BoundaryOf("image/jpeg"), std::nullopt);
  EXPECT_EQ(BoundaryOf("multipart/x-mixed-replace"), std::nullopt);
  EXPECT_EQ(BoundaryOf("multipart/x-mixed-replace;boundary="), std::nullopt);
  EXPECT_EQ(BoundaryOf("multipart/x;boundary=" + std::string(71, 'a')), std::nullopt);
}

TEST(MjpegParser, CutsTheRobotsStreamHoweverItsBytesArrive) {
  const std::string first = JpegSample(16, 16, 'a'), second = JpegSample(16, 16, 'b');
  const std::string stream = kPartHeader + first + kPartHeader + second + kPartHeader;
  for (size_t piece = 1; piece <= stream.size(); ++piece) {
    const Parsed parsed = Parse(stream, piece);
    ASSERT_EQ(parsed.parts.size(), 2u) << piece;
    EXPECT_EQ(parsed.parts[0].body, first);
    EXPECT_EQ(parsed.parts[1].body, second);
  }
}

TEST(MjpegParser, HandsOnAWholeImageBeforeTheNextBoundaryComes) {
  EXPECT_EQ(Parse(kPartHeader + JpegSample(16, 16), 64).parts.size(), 1u);
}

TEST(MjpegParser, StampsAPartWithTheFirstByteOfItsBoundary) {
  const std::string first = JpegSample(16, 16, 'a');
  const std::string stream = kPartHeader + first + kPartHeader + JpegSample(16, 16, 'b');
  const Parsed parsed = Parse(stream, 1);
  ASSERT_EQ(parsed.parts.size(), 2u);
  EXPECT_EQ(parsed.parts[0].stamp_ns, 1);
  EXPECT_EQ(parsed.parts[1].stamp_ns,
            static_cast<int64_t>(sizeof(kPartHeader) - 1 + first.size() + 1));
}

TEST(MjpegParser, TakesIdleLineEndsJunkAndLineFeedsAlone) {
  const std::string image = JpegSample(16, 16);
  const std::string stream = "junk\r\n--WINBONDBOUDARY\nContent-Type: image/jpeg\n\n" + image +
                             "\r\n\r\n\r\n" + kPartHeader + image + "more junk" + kPartHeader +
                             image;
  for (const size_t piece : {size_t{1}, size_t{7}, stream.size()}) {
    const Parsed parsed = Parse(stream, piece);
    EXPECT_EQ(parsed.fault, MjpegFault::kNone);
    ASSERT_GE(parsed.parts.size(), 2u) << piece;
    EXPECT_EQ(parsed.parts.front().body, image);
    EXPECT_EQ(parsed.parts.back().body, image);
  }
}

TEST(MjpegParser, SkipsStatusTextParts) {
  const std::string image = JpegSample(16, 16);
  const std::string stream = kPartHeader + image +
                             "--WINBONDBOUDARY\r\nContent-Type: text/plain\r\n\r\n" +
                             std::string(96, '0') + "\r\n" + kPartHeader + image;
  const Parsed parsed = Parse(stream, stream.size());
  EXPECT_EQ(parsed.parts.size(), 2u);
  EXPECT_EQ(parsed.num_skipped, 1u);
}

TEST(MjpegParser, HandsOnATruncatedImageForOthersToJudge) {
  const std::string half = JpegSample(16, 16).substr(0, 150);
  const Parsed parsed = Parse(kPartHeader + half + kPartHeader + JpegSample(16, 16), 9);
  ASSERT_EQ(parsed.parts.size(), 2u);
  EXPECT_EQ(parsed.parts[0].body, half);
}

TEST(MjpegParser, ObeysALengthOfAPartWhereThereIsOne) {
  const std::string body = "not a JPEG --WINBONDBOUDARY inside";
  const std::string stream = "--WINBONDBOUDARY\r\nContent-Type: image/jpeg\r\nContent-Length: " +
                             std::to_string(body.size()) + "\r\n\r\n" + body + "\r\n" + kPartHeader;
  const Parsed parsed = Parse(stream, 5);
  ASSERT_EQ(parsed.parts.size(), 1u);
  EXPECT_EQ(parsed.parts[0].body, body);
}

TEST(MjpegParser, RefusesNegativeOverflowingAndDuplicateLengths) {
  for (const char* const lengths :
       {"Content-Length: -1\r\n", "Content-Length: 99999999999999999999999\r\n",
        "Content-Length: 10\r\nContent-Length: 10\r\n", "Content-Length: 1 0\r\n"}) {
    const std::string stream = std::string("--WINBONDBOUDARY\r\n") + lengths + "\r\n";
    EXPECT_EQ(Parse(stream, stream.size()).fault, MjpegFault::kBadContentLength) << lengths;
  }
}

TEST(MjpegParser, CapsHeadersPartsAndJunk) {
  MjpegParserOptions options;
  options.max_part_bytes = 4096;
  options.max_junk_bytes = 4096;
  const std::string start = "--WINBONDBOUDARY\r\n";
  EXPECT_EQ(Parse(start + std::string(5000, 'h'), 100, options).fault, MjpegFault::kHeaderTooLong);
  std::string many_lines = start;
  for (int i = 0; i < 40; ++i) many_lines += "A: b\r\n";
  EXPECT_EQ(Parse(many_lines, 100, options).fault, MjpegFault::kHeaderTooLong);
  EXPECT_EQ(Parse(kPartHeader + std::string(9000, 'p'), 100, options).fault,
            MjpegFault::kPartTooLong);
  EXPECT_EQ(Parse(start + "Content-Length: 4097\r\n\r\n", 100, options).fault,
            MjpegFault::kPartTooLong);
  EXPECT_EQ(Parse(std::string(9000, 'j'), 100, options).fault, MjpegFault::kTooMuchJunk);
}

TEST(MjpegParser, SurvivesRandomDamage) {
  const std::string stream = kPartHeader + JpegSample(16, 16) + "\r\n" + kPartHeader +
                             JpegSample(16, 16, 'y') + kPartHeader;
  Rng rng(5);
  for (int round = 0; round < 2000; ++round) {
    std::string damaged = stream;
    for (int change = 0; change < 5; ++change) {
      damaged[rng.UniformInt(static_cast<uint32_t>(damaged.size()))] =
          static_cast<char>(rng.UniformInt(256));
    }
    Parse(damaged, 1 + rng.UniformInt(200));
  }
}

}  // namespace
}  // namespace rovio_sfm
