#include "rovio_sfm/merging/map_keeper.h"

#include <gtest/gtest.h>

#include "merging/keeper_fixture.h"

namespace rovio_sfm {
namespace {

TEST(MapKeeper, MergesTwoSessionsFromOneOverlap) {
  Sessions sessions;
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  ASSERT_TRUE(sessions.InOneMap()) << sessions.keeper.Reports()[0].reason;
  const MapPlace place = sessions.keeper.PlaceOf(sessions.b.id());
  EXPECT_EQ(place.map.value, 1u);
  EXPECT_EQ(place.revision, 1u);
  EXPECT_NEAR(place.map_from_session.scale, 1.0 / OtherGauge().scale, 1e-6);
  for (const auto& [index, frame] : sessions.b.keyframes()) {
    const Rigid3 cam_from_map = TransformCamera(place.map_from_session, frame.cam_from_session);
    EXPECT_LT(PoseDistance(cam_from_map, sessions.two.world.cams_from_map[CameraOf(true, index)]),
              1e-4);
  }
  const MergeReport report = sessions.keeper.Reports()[0];
  EXPECT_EQ(report.verdict, MergeVerdict::kAccepted);
  EXPECT_GT(report.num_links, 50u);
  EXPECT_GT(report.num_found, 0.9 * report.num_expected);
}

TEST(MapKeeper, LetsAMatchWaitForThePoseOfItsFrame) {
  Sessions sessions;
  sessions.b.SetWeak(8, true);
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.num_waiting(), 1u);
  sessions.b.SetWeak(8, false);
  sessions.keeper.Advance();
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.num_waiting(), 0u);
}

TEST(MapKeeper, LetsAMatchWaitForTheScaleItNeeds) {
  Sessions sessions;
  const PlaceMatch match = TrueOverlap(sessions.two, 8, 8);
  for (const FeatureMatch& inlier : match.pairs[0].inliers) {
    const TrackId track = sessions.b.keyframe(8).tracks[inlier.b];
    if (sessions.b.FindLandmark(track) != nullptr) sessions.b.RemoveLandmark(track);
  }
  sessions.keeper.Add(match);
  EXPECT_EQ(sessions.keeper.num_waiting(), 1u);
  sessions.a.set_scale({0.5, 0.05, "odometry"});
  sessions.b.set_scale({0.5 / OtherGauge().scale, 0.05, "odometry"});
  sessions.keeper.Advance();
  EXPECT_EQ(sessions.keeper.num_waiting(), 0u);
  ASSERT_EQ(sessions.keeper.Reports().size(), 1u);
  EXPECT_TRUE(sessions.keeper.Reports()[0].by_resection) << sessions.keeper.Reports()[0].reason;
}

TEST(MapKeeper, GivesUpWithAReasonWhatWaitedInVain) {
  MergeOptions merge;
  merge.patience = 3;
  Sessions sessions(MakeTwoDrives(), WithMerge(merge));
  PlaceMatch match = TrueOverlap(sessions.two, 8, 8);
  match.query.index = 99;
  sessions.keeper.Add(match);
  for (int i = 0; i < 4; ++i) sessions.keeper.Advance();
  EXPECT_EQ(sessions.keeper.num_waiting(), 0u);
  ASSERT_EQ(sessions.keeper.Reports().size(), 1u);
  EXPECT_NE(sessions.keeper.Reports()[0].reason.find("/99 has no pose"), std::string::npos);
}

TEST(MapKeeper, RefusesMatchesThatFitNoSimilarity) {
  Sessions sessions;
  PlaceMatch match = TrueOverlap(sessions.two, 8, 8);
  Rng rng(5);
  for (FeatureMatch& inlier : match.pairs[0].inliers) {
    inlier.a = rng.UniformInt(static_cast<uint32_t>(sessions.two.a[8].tracks.size()));
  }
  const std::string before = sessions.Bytes();
  sessions.keeper.Add(match);
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.Reports()[0].verdict, MergeVerdict::kRefused);
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapKeeper, RefusesAWrongPlaceThoughItsMatchesFit) {
  // The matches of frame 8 given as those of the same points moved aside: a repeated object.
  const TwoDrives two = MakeTwoDrives();
  Sessions sessions(two);
  const Sim3 aside{
      1.0, Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY())), {1.0, 0.0, 0.5}};
  sessions.keeper.Add(TrueOverlap(two, 8, 8));
  ASSERT_TRUE(sessions.InOneMap());
  Sessions wrong(two);
  wrong.b = MappedSession(two, true, aside);
  const Session moved = wrong.b;
  for (const auto& [index, frame] : moved.keyframes()) {
    // Poses elsewhere than where the landmarks say: what should be visible is not there.
    wrong.b.SetPose(index, TransformCamera(Inverse(aside), frame.cam_from_session));
  }
  wrong.keeper.Add(TrueOverlap(two, 8, 8));
  EXPECT_FALSE(wrong.InOneMap()) << wrong.keeper.Reports()[0].reason;
}

TEST(MapKeeper, KeepsAMatchOnOneSpotProvisionalUntilAnotherConfirmsIt) {
  Sessions sessions;
  const auto poster = [&](uint32_t frame, double sign) {  // matches of one half of the image
    PlaceMatch match = TrueOverlap(sessions.two, frame, frame);
    const Keyframe& query = sessions.b.keyframe(frame);
    auto& inliers = match.pairs[0].inliers;
    inliers.erase(std::remove_if(inliers.begin(), inliers.end(),
                                 [&](const FeatureMatch& inlier) {
                                   return sign * query.points[inlier.b].x() < 0.05;
                                 }),
                  inliers.end());
    return match;
  };
  MergeOptions strict;
  strict.evidence.min_inliers = 100000;  // nothing is proof by itself
  Sessions guarded(sessions.two, WithMerge(strict));
  guarded.keeper.Add(poster(3, 1.0));
  EXPECT_FALSE(guarded.InOneMap());
  EXPECT_EQ(guarded.keeper.Reports()[0].verdict, MergeVerdict::kProvisional);
  guarded.keeper.Add(poster(4, 1.0));  // the same landmarks again: no confirmation
  EXPECT_FALSE(guarded.InOneMap());
}

TEST(MapKeeper, ClosesALoopWithoutMovingASession) {
  Sessions sessions;
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  sessions.keeper.Add(TrueOverlap(sessions.two, 3, 3));
  const std::vector<MergeReport> reports = sessions.keeper.Reports();
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[1].kind, MergeKind::kLoop);
  EXPECT_EQ(reports[1].verdict, MergeVerdict::kAccepted);
  EXPECT_EQ(sessions.keeper.PlaceOf(sessions.b.id()).revision, 1u);
}

// As a restarted place recognition says it.
TEST(MapKeeper, IgnoresAMatchThatIsSaidAgain) {
  Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  const std::string before = sessions.Bytes();
  PlaceMatch turned = TrueOverlap(sessions.two, 8, 8);  // the other frame asks
  std::swap(turned.query, turned.pairs[0].other);
  for (FeatureMatch& inlier : turned.pairs[0].inliers) std::swap(inlier.a, inlier.b);
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  sessions.keeper.Add(turned);
  EXPECT_EQ(sessions.keeper.num_repeated(), 2u);
  EXPECT_EQ(sessions.keeper.Reports().size(), 1u);
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapKeeper, IgnoresAMatchThatIsSaidAgainWhileTheFirstWaits) {
  Sessions sessions;
  sessions.b.SetWeak(8, true);
  for (int i = 0; i < 2; ++i) {
    sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  }
  EXPECT_EQ(sessions.keeper.num_waiting(), 1u);
  EXPECT_EQ(sessions.keeper.num_repeated(), 1u);
}

TEST(MapKeeper, HearsAgainAMatchThatWaitedInVain) {
  Sessions sessions;
  sessions.b.SetWeak(8, true);
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  sessions.keeper.GiveUpWaiting();
  sessions.b.SetWeak(8, false);
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.num_repeated(), 0u);
}

TEST(MapKeeper, MergesOnlyByRequestWhereAutomaticIsOff) {
  MergeOptions merge;
  merge.automatic = false;
  Sessions sessions(MakeTwoDrives(), WithMerge(merge));
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  EXPECT_FALSE(sessions.InOneMap());
  const MergeReport report = sessions.keeper.Merge(sessions.a.id(), sessions.b.id(), false);
  EXPECT_EQ(report.verdict, MergeVerdict::kAccepted) << report.reason;
  EXPECT_TRUE(sessions.InOneMap());
}

TEST(MapKeeper, SaysWhyARequestCannotBeMet) {
  Sessions sessions;
  const MergeReport none = sessions.keeper.Merge(sessions.a.id(), sessions.b.id(), true);
  EXPECT_EQ(none.verdict, MergeVerdict::kRefused);
  EXPECT_NE(none.reason.find("no overlap"), std::string::npos);
  EXPECT_TRUE(sessions.keeper.Unmerge(sessions.a.id()).empty());
}

TEST(MapKeeper, GivesTheSameBytesTwice) {
  std::string bytes[2];
  for (std::string& run : bytes) {
    Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
    sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
    sessions.keeper.Add(TrueOverlap(sessions.two, 3, 3));
    sessions.keeper.AdjustAllFinally();
    run = sessions.Bytes();
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

// The result of an adjustment that a merge overtook is thrown away, and the new map's comes.
TEST(MapKeeper, AMergeOvertakesTheAdjustmentThatRuns) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  for (int i = 0; i < ResultDelay(48); ++i) three.keeper.CountKeyframe();
  const std::vector<MergeReport> reports = three.keeper.Reports();
  EXPECT_FALSE(reports[0].error_after_px);
  ASSERT_TRUE(reports[1].error_after_px);
}

TEST(MapKeeper, KnowsWhichSessionsAreLinked) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  EXPECT_TRUE(three.keeper.IsLinked(three.a.id()));
  EXPECT_TRUE(three.keeper.IsLinked(three.b.id()));
  EXPECT_FALSE(three.keeper.IsLinked(three.c.id()));
  three.keeper.Unmerge(three.a.id());
  EXPECT_FALSE(three.keeper.IsLinked(three.b.id()));
}

// As its drive would adjust a session that no links join.
TEST(MapKeeper, AdjustsALinkedMapAgainOnceItHasGrown) {
  Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  sessions.PassKeyframes();
  const Rigid3 adjusted = sessions.b.keyframe(3).cam_from_session;
  const Rigid3 aside{adjusted.rotation, adjusted.translation + Eigen::Vector3d(0.05, 0.0, 0.0)};
  sessions.b.SetPose(3, aside);
  for (int i = 0; i < 2; ++i) sessions.PassKeyframes();
  EXPECT_EQ(PoseDistance(sessions.b.keyframe(3).cam_from_session, aside), 0.0);
  Keyframe newcomer = sessions.b.keyframe(3);
  newcomer.weak = true;
  std::fill(newcomer.tracks.begin(), newcomer.tracks.end(), TrackId{0});
  for (uint32_t index = 100; index < 108; ++index) sessions.b.AddKeyframe(index, newcomer);
  for (int i = 0; i < 2; ++i) sessions.PassKeyframes();
  EXPECT_LT(PoseDistance(sessions.b.keyframe(3).cam_from_session, adjusted), 0.01);
}

// Two sessions in one map, whose adjustment runs, and an overlap that gapes until it is done.
struct GapingSessions : Sessions {
  GapingSessions() : Sessions(MakeTwoDrives(TwoDrivesOptions(0.7))) {
    keeper.Add(TrueOverlap(two, 8, 8));
    const auto poses = b.keyframes();
    for (const auto& [index, frame] : poses) {  // as a long way from the first overlap may have it
      const Rigid3 aside{Eigen::Quaterniond::Identity(), {0.2, 0.0, 0.0}};
      if (index < 4) b.SetPose(index, frame.cam_from_session * aside);
    }
    keeper.Add(TrueOverlap(two, 2, 2));
  }
};

// What would have to be judged in full while the map is adjusted may fit it afterwards.
TEST(MapKeeper, AnOverlapThatGapesWaitsForTheAdjustmentOfItsMap) {
  GapingSessions sessions;
  ASSERT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.num_waiting(), 1u);
  sessions.PassKeyframes();
  sessions.keeper.Advance();
  EXPECT_EQ(sessions.keeper.num_waiting(), 0u);
}

TEST(MapKeeper, AnOverlapThatWaitsAtTheEndIsJudgedAfterTheLastAdjustment) {
  GapingSessions sessions;
  ASSERT_EQ(sessions.keeper.num_waiting(), 1u);
  sessions.keeper.AdjustAllFinally();
  EXPECT_EQ(sessions.keeper.num_waiting(), 0u);
  ASSERT_EQ(sessions.keeper.Reports().size(), 2u);
  EXPECT_EQ(sessions.keeper.Reports()[1].verdict, MergeVerdict::kAccepted);
}

}  // namespace
}  // namespace rovio_sfm
