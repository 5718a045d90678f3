#include "rovio_sfm/io/map_store_merge_codec.h"

#include <gtest/gtest.h>

#include "io/random_records.h"

namespace rovio_sfm {
namespace {

const FrameId kQuery{{"second", 2, 7}, 5};
const FrameId kOther{{"first", 1, 0}, 9};

int64_t RowOf(const DriveId& drive) { return drive == kQuery.drive ? 2 : 1; }

DriveId DriveOfRow(int64_t row) {
  if (row == 1) return kOther.drive;
  if (row == 2) return kQuery.drive;
  throw StoreError("match: drive = " + std::to_string(row) + ": expected 1 or 2");
}

DriveId DriveOfReport(int64_t row) {
  if (row == 1 || row == 2) return DriveOfRow(row);
  throw StoreError("report: drive = " + std::to_string(row) + ": expected 1 or 2");
}

TEST(MapStoreMergeCodec, GivesBackPlaceMatches) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    const PlaceMatch match = RandomMatch(kQuery, kOther, rng);
    const PlaceMatch again = ReadMatch(BlobOf(MatchBytes(match, RowOf)), DriveOfRow);
    EXPECT_EQ(again.query, match.query);
    EXPECT_EQ(again.probability, match.probability);
    EXPECT_EQ(again.score, match.score);
    ASSERT_EQ(again.pairs.size(), match.pairs.size());
    for (size_t i = 0; i < match.pairs.size(); ++i) {
      const OverlapPair &a = again.pairs[i], &b = match.pairs[i];
      EXPECT_EQ(a.other, b.other);
      EXPECT_EQ(a.verdict, b.verdict);
      EXPECT_EQ(a.query_from_other.rotation.coeffs(), b.query_from_other.rotation.coeffs());
      EXPECT_EQ(a.query_from_other.translation, b.query_from_other.translation);
      ASSERT_EQ(a.inliers.size(), b.inliers.size());
      for (size_t j = 0; j < b.inliers.size(); ++j) {
        EXPECT_EQ(a.inliers[j].a, b.inliers[j].a);
        EXPECT_EQ(a.inliers[j].b, b.inliers[j].b);
        EXPECT_EQ(a.inliers[j].distance, b.inliers[j].distance);
        EXPECT_EQ(a.inliers[j].ratio, b.inliers[j].ratio);
      }
    }
  }
}

TEST(MapStoreMergeCodec, GivesBackReportsLinksAndMarks) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    const MergeReport report = RandomReport(kQuery, kOther, rng);
    EXPECT_TRUE(ReadReport(BlobOf(ReportBytes(report, RowOf)), DriveOfRow) == report);
    const std::vector<FeatureLink> links = RandomLinks(rng);
    EXPECT_EQ(ReadLinks(BlobOf(LinkBytes(links))), links);
    const std::map<SessionId, uint32_t> marks = {{{1}, rng.UniformInt(9)}, {{2}, 5}};
    EXPECT_EQ(ReadMarks(BlobOf(MarkBytes(marks))), marks);
  }
}

TEST(MapStoreMergeCodec, RefusesSpoiltBytesWithTheColumnNamed) {
  Rng rng(3);
  PlaceMatch match = RandomMatch(kQuery, kOther, rng);
  match.pairs[0].inliers.resize(2);
  EXPECT_GT(CountRefused(
                MatchBytes(match, RowOf), "match",
                [](const Blob& bytes) { return MatchBytes(ReadMatch(bytes, DriveOfRow), RowOf); }),
            100u);
  EXPECT_GT(CountRefused(ReportBytes(RandomReport(kQuery, kOther, rng), RowOf), "report",
                         [](const Blob& bytes) {
                           return ReportBytes(ReadReport(bytes, DriveOfReport), RowOf);
                         }),
            100u);
  std::vector<FeatureLink> links(3);
  EXPECT_GT(CountRefused(LinkBytes(links), "links",
                         [](const Blob& bytes) { return LinkBytes(ReadLinks(bytes)); }),
            60u);
  EXPECT_GT(CountRefused(MarkBytes({{{1}, 5}, {{3}, 6}}), "marks",
                         [](const Blob& bytes) { return MarkBytes(ReadMarks(bytes)); }),
            10u);
}

}  // namespace
}  // namespace rovio_sfm
