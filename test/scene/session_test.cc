#include "rovio_sfm/scene/session.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

Session EmptySession() { return Session({1}, {"rovio", 1, 0}, MakeSyntheticCamera()); }

// A keyframe whose features are in these tracks.
Keyframe FrameWith(const std::vector<TrackId>& tracks) {
  Keyframe frame;
  frame.tracks = tracks;
  frame.points.assign(tracks.size(), Eigen::Vector2d::Zero());
  frame.sigmas.assign(tracks.size(), 0.001);
  frame.colors.resize(tracks.size());
  return frame;
}

// Frames 0 and 1 see tracks 1 and 2; frames 2 and 3 see tracks 3 and 4.
Session TwoHalves() {
  Session session = EmptySession();
  session.AddKeyframe(0, FrameWith({1, 2}));
  session.AddKeyframe(1, FrameWith({1, 2}));
  session.AddKeyframe(2, FrameWith({3, 4}));
  session.AddKeyframe(3, FrameWith({3, 4}));
  return session;
}

void ExpectValid(const Session& session) { EXPECT_EQ(CheckInvariants(session), ""); }

TEST(Session, LeavesASecondFeatureOfATrackInAFrameWithoutTrack) {
  Session session = EmptySession();
  session.AddKeyframe(0, FrameWith({5, 0, 5}));
  EXPECT_EQ(session.keyframe(0).tracks, (std::vector<TrackId>{5, 0, 0}));
  EXPECT_EQ(session.tracks().at(5).members.size(), 1u);
  ExpectValid(session);
}

TEST(Session, ResolvesAliasesOfNewFrames) {
  Session session = TwoHalves();
  ASSERT_TRUE(session.UniteTracks(3, 1));
  EXPECT_EQ(session.RootOf(3), 1u);
  session.AddKeyframe(4, FrameWith({3, 1, 4}));
  EXPECT_EQ(session.keyframe(4).tracks, (std::vector<TrackId>{1, 0, 4}));
  EXPECT_EQ(session.tracks().at(1).members.size(), 5u);
  ExpectValid(session);
}

TEST(Session, RemovingAKeyframeTakesItsTwoViewLandmarksAndLightFrames) {
  Session session = TwoHalves();
  session.AddKeyframe(4, FrameWith({1}));
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}, {4, 0}});
  session.AddLandmark(2, {0, 0, 1}, {}, {{0, 1}, {1, 1}});
  LightFrame light;
  light.reference = 1;
  session.AddLightFrame(7, light);
  session.RemoveKeyframe(1);
  EXPECT_EQ(session.landmarks().at(1).observations.size(), 2u);
  EXPECT_EQ(session.FindLandmark(2), nullptr);
  EXPECT_EQ(session.keyframe(0).num_observed, 1u);
  EXPECT_TRUE(session.light_frames().empty());
  ExpectValid(session);
}

TEST(Session, RemovingAnObservationOfTwoRemovesTheLandmarkButNotTheTrack) {
  Session session = TwoHalves();
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}});
  session.RemoveObservation(1, {0, 0});
  EXPECT_EQ(session.FindLandmark(1), nullptr);
  EXPECT_EQ(session.tracks().at(1).members.size(), 2u);
  ExpectValid(session);
}

TEST(Session, UnitesTracksUnderTheSmallerRootWithTheLandmark) {
  Session session = TwoHalves();
  session.AddLandmark(3, {1, 2, 3}, {9, 9, 9}, {{2, 0}, {3, 0}});
  ASSERT_TRUE(session.UniteTracks(3, 1));
  EXPECT_EQ(session.tracks().count(3), 0u);
  ASSERT_NE(session.FindLandmark(3), nullptr);
  EXPECT_EQ(session.FindLandmark(3), session.FindLandmark(1));
  EXPECT_EQ(session.FindLandmark(1)->observations.size(), 2u);
  EXPECT_EQ(session.FindLandmark(1)->position, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(session.UniteTracks(1, 3));
  ExpectValid(session);
}

TEST(Session, RefusesToUniteTracksSeenInOneFrame) {
  Session session = TwoHalves();
  EXPECT_TRUE(session.HasMembersInOneFrame(1, 2));
  EXPECT_FALSE(session.UniteTracks(1, 2));
  EXPECT_FALSE(session.HasMembersInOneFrame(1, 3));
  ASSERT_TRUE(session.UniteTracks(1, 3));
  EXPECT_TRUE(session.HasMembersInOneFrame(3, 4));
  EXPECT_FALSE(session.UniteTracks(3, 4));
  EXPECT_EQ(session.RootOf(4), 4u);
  ExpectValid(session);
}

TEST(Session, LeavesTwoLandmarksToUniteLandmarks) {
  Session session = TwoHalves();
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}});
  session.AddLandmark(3, {0, 0, 2}, {}, {{2, 0}, {3, 0}});
  EXPECT_FALSE(session.UniteTracks(1, 3));
  ASSERT_TRUE(session.UniteLandmarks(3, 1, {0, 0, 1.5}));
  EXPECT_EQ(session.landmarks().size(), 1u);
  EXPECT_EQ(session.landmarks().at(1).observations.size(), 4u);
  EXPECT_EQ(session.landmarks().at(1).position.z(), 1.5);
  ExpectValid(session);
}

TEST(Session, KeepsLandmarksApartThatOneFrameSees) {
  Session session = TwoHalves();
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}});
  session.AddLandmark(2, {0, 0, 2}, {}, {{0, 1}, {1, 1}});
  EXPECT_FALSE(session.UniteLandmarks(1, 2, {0, 0, 3}));
  EXPECT_EQ(session.landmarks().at(1).position.z(), 1.0);
  EXPECT_EQ(session.landmarks().size(), 2u);
  ExpectValid(session);
}

TEST(Session, UnitesTracksItHasNotSeenYet) {
  Session session = EmptySession();
  EXPECT_TRUE(session.UniteTracks(8, 6));
  session.AddKeyframe(0, FrameWith({8}));
  session.AddKeyframe(1, FrameWith({6}));
  EXPECT_EQ(session.tracks().at(6).members.size(), 2u);
  ExpectValid(session);
}

TEST(Session, MovesOnlyLoneUnobservedFeaturesToAnotherTrack) {
  Session session = TwoHalves();
  session.AddKeyframe(4, FrameWith({0, 9, 3, 4}));
  EXPECT_TRUE(session.MoveToTrack({4, 0}, 1));   // in no track
  EXPECT_FALSE(session.MoveToTrack({4, 1}, 1));  // frame 4 is in track 1 now
  EXPECT_TRUE(session.MoveToTrack({4, 1}, 2));   // alone in its own
  EXPECT_EQ(session.tracks().count(9), 0u);
  EXPECT_FALSE(session.MoveToTrack({2, 0}, 1));  // its track has other members
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}, {4, 0}});
  EXPECT_FALSE(session.MoveToTrack({4, 0}, 3));  // observed
  EXPECT_EQ(session.keyframe(4).tracks, (std::vector<TrackId>{1, 2, 3, 4}));
  ExpectValid(session);
}

// Every mutator; a snapshot tells the revision of what it shows.
TEST(Session, EveryChangeRaisesTheRevision) {
  Session session = TwoHalves();
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}});
  session.AddLandmark(3, {0, 0, 1}, {}, {{2, 0}, {3, 0}});
  uint64_t last = session.revision();
  const auto expect_raised = [&](const char* what) {
    EXPECT_GT(session.revision(), last) << what;
    last = session.revision();
  };
  session.set_state(SessionState::kLost);
  expect_raised("set_state");
  session.set_scale(MapScale{2.0, 0.1, "odometry"});
  expect_raised("set_scale");
  session.set_odometry_delay(OdometryDelay{0.1, 0.01});
  expect_raised("set_odometry_delay");
  const uint32_t frame = session.keyframes().begin()->first;
  session.SetPose(frame, Rigid3());
  expect_raised("SetPose");
  session.SetWeak(frame, true);
  expect_raised("SetWeak");
  const TrackId track = session.landmarks().begin()->first;
  session.SetPosition(track, Eigen::Vector3d(1.0, 2.0, 3.0));
  expect_raised("SetPosition");
  session.RemoveObservation(track, session.landmarks().at(track).observations.front());
  expect_raised("RemoveObservation");
  EXPECT_TRUE(session.UniteTracks(1, 3));
  expect_raised("UniteTracks");
  LightFrame light;
  light.reference = frame;
  session.AddLightFrame(1000, light);
  expect_raised("AddLightFrame");
  session.RemoveKeyframe(frame);
  expect_raised("RemoveKeyframe");
  EXPECT_EQ(session.Snapshot().revision, last);
  EXPECT_EQ(session.revision(), last) << "a snapshot changes nothing";
}

TEST(ObservedLandmark, IsNoneForFramesAndFeaturesThatAreNotThere) {
  Session session = TwoHalves();
  session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 0}});
  EXPECT_EQ(ObservedLandmark(session, {session.id(), 0, 0}), session.FindLandmark(1));
  EXPECT_EQ(ObservedLandmark(session, {session.id(), 0, 1}), nullptr) << "it observes nothing";
  EXPECT_EQ(ObservedLandmark(session, {session.id(), 0, 4000000000}), nullptr);
  EXPECT_EQ(ObservedLandmark(session, {session.id(), 77, 0}), nullptr);
}

TEST(SessionDeathTest, EndsOnBreachesOfItsContract) {
  Session session = TwoHalves();
  EXPECT_DEATH(session.keyframe(17), "no keyframe 17");
  EXPECT_DEATH(session.AddKeyframe(0, FrameWith({1})), "check failed");
  EXPECT_DEATH(session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}}), "check failed");
  EXPECT_DEATH(session.AddLandmark(1, {0, 0, 1}, {}, {{0, 0}, {1, 1}}), "check failed");
  LightFrame light;
  light.reference = 17;
  EXPECT_DEATH(session.AddLightFrame(9, light), "check failed");
}

}  // namespace
}  // namespace rovio_sfm
