#include "rovio_sfm/merging/adjust_map.h"

#include <gtest/gtest.h>

#include "merging/merged_pair.h"

namespace rovio_sfm {
namespace {

MapAdjustmentReport AdjustBeside(MergedPair* pair) {
  Executor executor{0};
  MapAdjustment adjustment(pair->placed, pair->links, {}, &executor, ResultTiming::kFixed);
  return adjustment.Apply({}, &pair->links);
}

TEST(AdjustMap, LeavesAPerfectMapAsItIs) {
  MergedPair pair;
  const size_t num_links = pair.links.size();
  const MapAdjustmentReport report = AdjustMapFinally(pair.placed, {}, &pair.links);
  EXPECT_TRUE(report.usable);
  EXPECT_LT(report.after.median_error_px, 1e-6);
  EXPECT_EQ(pair.links.size(), num_links);
  EXPECT_LT(pair.ErrorOfB(), 1e-6);
  EXPECT_EQ(CheckInvariants(pair.a) + CheckInvariants(pair.b), "");
}

TEST(AdjustMap, PullsAMisplacedSessionIntoItsPlace) {
  MergedPair pair;
  pair.placed[1].map_from_session =
      Sim3{1.01,
           Eigen::Quaterniond(Eigen::AngleAxisd(0.004, Eigen::Vector3d::UnitY())),
           {0.01, 0.0, 0.01}} *
      pair.placed[1].map_from_session;
  ASSERT_GT(pair.ErrorOfB(), 0.01);
  const MapAdjustmentReport report = AdjustMapFinally(pair.placed, {}, &pair.links);
  EXPECT_TRUE(report.usable);
  EXPECT_GT(report.before.median_error_px, 1.0);
  EXPECT_LT(report.after.median_error_px, 0.01);
  EXPECT_LT(pair.ErrorOfB(), 1e-3);
}

// As the final adjustment of a session alone does.
TEST(AdjustMap, CompletesTheTracksOfItsSessions) {
  MergedPair pair;
  const size_t num_landmarks = pair.b.landmarks().size();
  std::vector<TrackId> every_third;
  for (const auto& [id, landmark] : pair.b.landmarks()) {
    if (id % 3 == 0) every_third.push_back(id);
  }
  for (const TrackId id : every_third) pair.b.RemoveLandmark(id);
  AdjustMapFinally(pair.placed, {}, &pair.links);
  EXPECT_EQ(pair.b.landmarks().size(), num_landmarks);
  EXPECT_EQ(CheckInvariants(pair.b), "");
}

TEST(AdjustMap, KeepsTheErrorBoundedWithNoise) {
  MergedPair pair(0.7);
  AdjustMapFinally(pair.placed, {}, &pair.links);
  EXPECT_LT(pair.ErrorOfB(), 0.03);
}

TEST(AdjustMap, DropsLinksThatDoNotFit) {
  MergedPair pair;
  FeatureLink wrong = pair.links.front();
  for (const FeatureLink& other : pair.links) {  // a feature far away in the same frame
    if (other.b.frame != wrong.b.frame) continue;
    const auto& points = pair.b.keyframe(wrong.b.frame).points;
    if ((points[other.b.feature] - points[wrong.b.feature]).norm() > 0.3) {
      wrong.b.feature = other.b.feature;
      break;
    }
  }
  pair.links.insert(std::upper_bound(pair.links.begin(), pair.links.end(), wrong), wrong);
  const size_t before = pair.links.size();
  const MapAdjustmentReport report = AdjustBeside(&pair);
  EXPECT_EQ(report.num_dropped_links, 1u);
  EXPECT_EQ(pair.links.size(), before - 1);
  EXPECT_LT(pair.ErrorOfB(), 1e-4);
}

TEST(AdjustMap, DoesNothingToFramesThatAreGone) {
  MergedPair pair;
  pair.b.RemoveKeyframe(8);
  const MapAdjustmentReport report = AdjustBeside(&pair);
  EXPECT_TRUE(report.usable);
  EXPECT_LT(pair.ErrorOfB(), 1e-5);
}

// A frame that came while the map was solved rides with the frame before it.
TEST(MapAdjustment, MovesWhatWasBornSinceWithItsReference) {
  MergedPair pair;
  const Keyframe newest = pair.b.keyframe(15);
  pair.b.RemoveKeyframe(15);
  const Sim3 aside{1.0, Eigen::Quaterniond::Identity(), {0.05, 0.0, 0.0}};
  pair.placed[1].map_from_session = aside * pair.placed[1].map_from_session;
  Executor executor{0};
  MapAdjustment adjustment(pair.placed, pair.links, {}, &executor, ResultTiming::kFixed);
  pair.b.AddKeyframe(15, newest);
  for (uint32_t i = 0; i < newest.tracks.size(); ++i) {
    if (pair.b.landmarks().count(newest.tracks[i]) != 0) {
      pair.b.AddObservation(newest.tracks[i], {15, i});
    }
  }
  const Rigid3 step = newest.cam_from_session * Inverse(pair.b.keyframe(14).cam_from_session);
  ASSERT_TRUE(adjustment.Apply({}, &pair.links).usable);
  const Rigid3 moved =
      pair.b.keyframe(15).cam_from_session * Inverse(pair.b.keyframe(14).cam_from_session);
  EXPECT_LT(PoseDistance(moved, step), 1e-9);
  EXPECT_GT(PoseDistance(pair.b.keyframe(15).cam_from_session, newest.cam_from_session), 1e-3);
}

}  // namespace
}  // namespace rovio_sfm
