#include "rovio_sfm/merging/match_across_break.h"

#include <gtest/gtest.h>

#include "app/explored_land.h"
#include "rovio_sfm/merging/align_overlap.h"

namespace rovio_sfm {
namespace {

// Frames first to last of a drive as a session of their own.
Session SessionOf(const Explored& drive, uint32_t id, uint32_t first, uint32_t last,
                  const Sim3& session_from_world) {
  Session session({id}, drive.session.drive(), drive.session.camera());
  for (uint32_t i = first; i <= last; ++i) {
    const Rigid3& cam_from_world = drive.session.keyframe(i).cam_from_session;
    session.AddKeyframe(
        i, MakeKeyframe(drive.events[i], TransformCamera(session_from_world, cam_from_world), {}));
  }
  for (const auto& [track, members] : session.tracks()) {
    if (members.members.size() < 2) continue;
    session.AddLandmark(track, session_from_world * drive.land.points[track - 1], {},
                        members.members);
  }
  return session;
}

Explored DriveInARoom() {
  Land land;
  AddClutter(1, 400, &land);
  return Explore(1, land, {});
}

TEST(MatchAcrossBreak, FramesThatShowTheSameTracksOverlap) {
  const Explored drive = DriveInARoom();
  const Session before = SessionOf(drive, 1, 0, 9, {}), after = SessionOf(drive, 2, 10, 19, {});
  const std::vector<PlaceMatch> matches = MatchAcrossBreak(before, after);
  ASSERT_FALSE(matches.empty());
  const PlaceMatch& first = matches.front();
  EXPECT_EQ(first.query, (FrameId{before.drive(), 10}));
  EXPECT_EQ(first.pairs.front().other, (FrameId{before.drive(), 9}));
  for (const FeatureMatch& inlier : first.pairs.front().inliers) {
    EXPECT_EQ(drive.views[9][inlier.a], drive.views[10][inlier.b]);
  }
  EXPECT_EQ(CountSharedTracks(before, 9, after, 10), first.pairs.front().inliers.size());
}

TEST(MatchAcrossBreak, WhatSharesFewTracksDoesNot) {
  const Explored drive = DriveInARoom();
  Session before({1}, drive.session.drive(), drive.session.camera());
  FrameEvent event = drive.events[0];
  for (size_t i = kMinSharedTracks - 1; i < event.tracks.size(); ++i) event.tracks[i] = 0;
  before.AddKeyframe(0, MakeKeyframe(event, {}, {}));
  EXPECT_TRUE(MatchAcrossBreak(before, SessionOf(drive, 2, 1, 9, {})).empty());
}

TEST(MatchAcrossBreak, TracksOfTwoDrivesHaveNothingInCommon) {
  const Explored drive = DriveInARoom();
  const Explored other = Explore(2, drive.land, {});
  EXPECT_EQ(CountSharedTracks(drive.session, 3, other.session, 3), 0u);
}

// No landmark is common: what the session before was lost for.
TEST(MatchAcrossBreak, TwoFramesPosedInBothSessionsAlignThem) {
  const Explored drive = DriveInARoom();
  Session before = SessionOf(drive, 1, 0, 9, {});
  const Session after = SessionOf(drive, 2, 10, 19, OtherGauge());
  std::vector<TrackId> shared;
  for (const auto& [id, landmark] : before.landmarks()) {
    if (after.FindLandmark(id) != nullptr && id % 8 != 0) shared.push_back(id);
  }
  for (const TrackId id : shared) before.RemoveLandmark(id);
  const std::vector<PlaceMatch> matches = MatchAcrossBreak(before, after);
  ASSERT_FALSE(matches.empty());
  const OverlapAlignment aligned = AlignOverlap(before, after, 10, matches[0].pairs, {});
  ASSERT_TRUE(aligned.alignment) << aligned.reason;
  EXPECT_NEAR(std::log(aligned.alignment->b_from_a.scale / OtherGauge().scale), 0.0, 0.02);
}

}  // namespace
}  // namespace rovio_sfm
