#include "rovio_sfm/merging/align_overlap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

double ErrorOf(const SessionAlignment& alignment) {
  const Sim3 gap = alignment.b_from_a * Inverse(OtherGauge());
  return std::abs(std::log(gap.scale)) + RotationAngle(gap.rotation) + gap.translation.norm();
}

TEST(AlignOverlap, IsExactWithoutNoise) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  const OverlapAlignment aligned = AlignOverlap(a, b, 8, match.pairs, MapOptions());
  ASSERT_TRUE(aligned.alignment) << aligned.reason;
  EXPECT_LT(ErrorOf(*aligned.alignment), 1e-6);
  EXPECT_FALSE(aligned.alignment->by_resection);
}

TEST(AlignOverlap, ResectsWhereFewLandmarksAreCommon) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  // All but a few of the query's landmarks are gone: three points make no reliable 3D-3D model.
  size_t kept = 0;
  for (const FeatureMatch& inlier : match.pairs[0].inliers) {
    const TrackId track = b.keyframe(8).tracks[inlier.b];
    if (b.FindLandmark(track) == nullptr || ++kept <= 6) continue;
    b.RemoveLandmark(track);
  }
  const OverlapAlignment aligned = AlignOverlap(a, b, 8, match.pairs, MapOptions());
  ASSERT_TRUE(aligned.alignment) << aligned.reason;
  EXPECT_LT(ErrorOf(*aligned.alignment), 1e-3);
}

TEST(AlignOverlap, TakesTheScaleOfTheOdometryWhereNoLandmarkIsCommon) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  for (const FeatureMatch& inlier : match.pairs[0].inliers) {  // seen by this frame of b alone
    const TrackId track = b.keyframe(8).tracks[inlier.b];
    if (b.FindLandmark(track) != nullptr) b.RemoveLandmark(track);
  }
  EXPECT_FALSE(AlignOverlap(a, b, 8, match.pairs, MapOptions()).alignment);
  a.set_scale(MapScale{0.5, 0.2, "odometry"});
  b.set_scale(MapScale{0.5 / OtherGauge().scale, 0.05, "odometry"});
  const OverlapAlignment vague = AlignOverlap(a, b, 8, match.pairs, MapOptions());
  EXPECT_FALSE(vague.alignment);
  EXPECT_NE(vague.reason.find("scale"), std::string::npos) << vague.reason;
  a.set_scale(MapScale{0.5, 0.05, "odometry"});
  const OverlapAlignment aligned = AlignOverlap(a, b, 8, match.pairs, MapOptions());
  ASSERT_TRUE(aligned.alignment) << aligned.reason;
  EXPECT_LT(ErrorOf(*aligned.alignment), 1e-3);
  EXPECT_GT(aligned.alignment->sigma_log_scale, 0.05);
  EXPECT_EQ(aligned.alignment->num_common, 0);
}

TEST(AlignOverlap, SaysWhyThereIsNone) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const OverlapAlignment aligned = AlignOverlap(a, b, 8, {}, MapOptions());
  EXPECT_FALSE(aligned.alignment);
  EXPECT_NE(aligned.reason.find("no alignment"), std::string::npos);
}

TEST(AlignLinks, RefinesFromAPoorStart) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const Sim3 nudge{1.01, Eigen::Quaterniond::Identity(), {0.01, 0.0, 0.01}};
  const OverlapAlignment aligned = AlignLinks(a, b, LinksOf(TrueOverlap(two, 8, 8), a.id(), b.id()),
                                              nudge * OtherGauge(), MapOptions());
  ASSERT_TRUE(aligned.alignment) << aligned.reason;
  EXPECT_LT(ErrorOf(*aligned.alignment), 1e-5);
}

}  // namespace
}  // namespace rovio_sfm
