#include "rovio_sfm/merging/map_keeper.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

// Two perfectly mapped sessions in two gauges, ready to be merged.
struct Sessions {
  explicit Sessions(const TwoDrives& drives = MakeTwoDrives(), const MapOptions& options = {})
      : two(drives),
        store(StoreOf(two)),
        keeper(options, &store),
        a(keeper.LendSessions()->Adopt(MappedSession(two, false, {}))),
        b(keeper.LendSessions()->Adopt(MappedSession(two, true, OtherGauge()))) {
    a.set_state(SessionState::kMapping);
    b.set_state(SessionState::kMapping);
  }

  bool InOneMap() const { return keeper.PlaceOf(a.id()).map == keeper.PlaceOf(b.id()).map; }
  std::string Bytes() const { return BytesOf(a) + BytesOf(b); }

  TwoDrives two;
  MemoryFrameStore store;
  MapKeeper keeper;
  Session &a, &b;
};

MapOptions WithMerge(const MergeOptions& merge) {
  MapOptions options;
  options.merge = merge;
  return options;
}

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

TEST(MapKeeper, UndoesAForcedMergeToTheByte) {
  Sessions sessions;
  const std::string before = sessions.Bytes();
  sessions.keeper.MergeAt(sessions.a.id(), sessions.b.id(), {});
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.Unmerge(sessions.b.id()).size(), 1u);
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.Bytes(), before);
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  EXPECT_FALSE(sessions.InOneMap()) << "a place match joined what a request had separated";
}

TEST(MapKeeper, UndoesAnAdjustedMergeToTheByte) {
  Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
  const std::string before = sessions.Bytes();
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  ASSERT_TRUE(sessions.InOneMap());
  EXPECT_NE(sessions.Bytes(), before);
  sessions.keeper.Unmerge(sessions.b.id());
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapKeeper, GivesTheSameBytesTwice) {
  std::string bytes[2];
  for (std::string& run : bytes) {
    Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
    sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
    sessions.keeper.Add(TrueOverlap(sessions.two, 3, 3));
    sessions.keeper.AdjustFinally();
    run = sessions.Bytes();
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

// The two sessions, and a third that saw what the first saw, as a robot of its own.
struct ThreeSessions : Sessions {
  explicit ThreeSessions(const MapOptions& options = {})
      : Sessions(MakeTwoDrives(), options), c(AdoptThird()) {
    c.set_state(SessionState::kMapping);
  }

  Session& AdoptThird() {
    TwoDrives third = two;
    for (FrameEvent& event : third.a) {
      event.id.drive.robot = "third";
      store.Put(event.id, event.features);
    }
    Session session({3}, third.a[0].id.drive, two.world.camera);
    for (const auto& [index, frame] : a.keyframes()) session.AddKeyframe(index, frame);
    for (const auto& [id, landmark] : a.landmarks()) {
      session.AddLandmark(id, landmark.position, landmark.color, landmark.observations);
    }
    return keeper.LendSessions()->Adopt(std::move(session));
  }

  // Frame 8 of the third session shows what frame 8 of the second does.
  PlaceMatch OverlapOfThirdAndSecond() const {
    PlaceMatch match = TrueOverlap(two, 8, 8);
    std::swap(match.query, match.pairs[0].other);
    match.query.drive.robot = "third";
    for (FeatureMatch& inlier : match.pairs[0].inliers) std::swap(inlier.a, inlier.b);
    return match;
  }

  bool AreInOneMap(const Session& x, const Session& y) const {
    return keeper.PlaceOf(x.id()).map == keeper.PlaceOf(y.id()).map;
  }

  Session& c;
};

TEST(MapKeeper, UndoingKeepsAMergeOfOthersThatARequestMade) {
  MapOptions options;
  options.merge.automatic = false;
  ThreeSessions three(options);
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  ASSERT_EQ(three.keeper.Merge({1}, {2}, false).verdict, MergeVerdict::kAccepted);
  ASSERT_EQ(three.keeper.Merge({2}, {3}, false).verdict, MergeVerdict::kAccepted);
  ASSERT_EQ(three.keeper.Unmerge({1}).size(), 1u);
  EXPECT_FALSE(three.AreInOneMap(three.a, three.b));
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
  EXPECT_EQ(three.keeper.Reports().back().reason, "accepted by request");
}

TEST(MapKeeper, UndoingKeepsAMergeOfOthersThatEvidenceMade) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  ASSERT_TRUE(three.AreInOneMap(three.a, three.c));
  ASSERT_EQ(three.keeper.Unmerge({1}).size(), 1u);
  EXPECT_FALSE(three.AreInOneMap(three.a, three.b));
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
  const MapPlace place = three.keeper.PlaceOf(three.c.id());
  EXPECT_EQ(place.map.value, 2u);
  EXPECT_NEAR(place.map_from_session.scale, OtherGauge().scale, 1e-6);
}

TEST(MapKeeper, UndoingKeepsAMergeOfOthersThatAHandMade) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.MergeAt({2}, {3}, Inverse(OtherGauge()));
  ASSERT_EQ(three.keeper.Unmerge({1}).size(), 1u);
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
  EXPECT_EQ(three.keeper.PlaceOf({3}).map_from_session.scale, OtherGauge().scale);
}

// Whatever the merge that stayed apart from the undone one made, it is not touched.
TEST(MapKeeper, UndoingOneSessionOfThreeGivesTheOthersTheirBytes) {
  ThreeSessions three;
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  const std::string before = BytesOf(three.b) + BytesOf(three.c);
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  ASSERT_TRUE(three.AreInOneMap(three.a, three.c));
  three.keeper.Unmerge({1});
  EXPECT_EQ(BytesOf(three.b) + BytesOf(three.c), before);
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
}

// What was separated by request is not joined by way of a third session either.
TEST(MapKeeper, NoPlaceMatchBringsASessionBackToTheOthersOfItsMap) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  three.keeper.Unmerge({2});
  PlaceMatch later = three.OverlapOfThirdAndSecond();
  later.query.index = 9;
  three.keeper.Add(later);
  three.keeper.Add(TrueOverlap(three.two, 7, 7));
  EXPECT_FALSE(three.AreInOneMap(three.a, three.b));
  EXPECT_FALSE(three.AreInOneMap(three.b, three.c));
}

}  // namespace
}  // namespace rovio_sfm
