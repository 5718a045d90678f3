#include "rovio_sfm/merging/map_merger.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

// Two perfectly mapped sessions in two gauges, ready to be merged.
struct Sessions {
  explicit Sessions(const TwoDrives& drives = MakeTwoDrives(), const MapOptions& options = {})
      : two(drives),
        store(StoreOf(two)),
        a(MappedSession(two, false, {})),
        b(MappedSession(two, true, OtherGauge())),
        merger(options, &store) {
    a.set_state(SessionState::kMapping);
    b.set_state(SessionState::kMapping);
    table.Add(&a);
    table.Add(&b);
  }

  bool InOneMap() const { return merger.PlaceOf(a.id()).map == merger.PlaceOf(b.id()).map; }
  std::string Bytes() const { return BytesOf(a) + BytesOf(b); }

  TwoDrives two;
  MemoryFrameStore store;
  Session a, b;
  SessionTable table;
  MapMerger merger;
};

MapOptions WithMerge(const MergeOptions& merge) {
  MapOptions options;
  options.merge = merge;
  return options;
}

TEST(MapMerger, MergesTwoSessionsFromOneOverlap) {
  Sessions sessions;
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  ASSERT_TRUE(sessions.InOneMap()) << sessions.merger.Reports()[0].reason;
  const MapPlace place = sessions.merger.PlaceOf(sessions.b.id());
  EXPECT_EQ(place.map.value, 1u);
  EXPECT_EQ(place.revision, 1u);
  EXPECT_NEAR(place.map_from_session.scale, 1.0 / OtherGauge().scale, 1e-6);
  for (const auto& [index, frame] : sessions.b.keyframes()) {
    const Rigid3 cam_from_map = TransformCamera(place.map_from_session, frame.cam_from_session);
    EXPECT_LT(PoseDistance(cam_from_map, sessions.two.world.cams_from_map[CameraOf(true, index)]),
              1e-4);
  }
  const MergeReport report = sessions.merger.Reports()[0];
  EXPECT_EQ(report.verdict, MergeVerdict::kAccepted);
  EXPECT_GT(report.num_links, 50u);
  EXPECT_GT(report.num_found, 0.9 * report.num_expected);
  EXPECT_EQ(sessions.merger.TakeChanged().size(), 2u);
}

TEST(MapMerger, LetsAMatchWaitForThePoseOfItsFrame) {
  Sessions sessions;
  sessions.b.SetWeak(8, true);
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.merger.num_waiting(), 1u);
  sessions.b.SetWeak(8, false);
  sessions.merger.Advance(sessions.table);
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.merger.num_waiting(), 0u);
}

TEST(MapMerger, LetsAMatchWaitForTheScaleItNeeds) {
  Sessions sessions;
  const PlaceMatch match = TrueOverlap(sessions.two, 8, 8);
  for (const FeatureMatch& inlier : match.pairs[0].inliers) {
    const TrackId track = sessions.b.keyframe(8).tracks[inlier.b];
    if (sessions.b.FindLandmark(track) != nullptr) sessions.b.RemoveLandmark(track);
  }
  sessions.merger.Add(match, sessions.table);
  EXPECT_EQ(sessions.merger.num_waiting(), 1u);
  sessions.a.set_scale(MapScale{0.5, 0.05, "odometry"});
  sessions.b.set_scale(MapScale{0.5 / OtherGauge().scale, 0.05, "odometry"});
  sessions.merger.Advance(sessions.table);
  EXPECT_EQ(sessions.merger.num_waiting(), 0u);
  ASSERT_EQ(sessions.merger.Reports().size(), 1u);
  EXPECT_TRUE(sessions.merger.Reports()[0].by_resection) << sessions.merger.Reports()[0].reason;
}

TEST(MapMerger, GivesUpWithAReasonWhatWaitedInVain) {
  MergeOptions merge;
  merge.patience = 3;
  Sessions sessions(MakeTwoDrives(), WithMerge(merge));
  PlaceMatch match = TrueOverlap(sessions.two, 8, 8);
  match.query.index = 99;
  sessions.merger.Add(match, sessions.table);
  for (int i = 0; i < 4; ++i) sessions.merger.Advance(sessions.table);
  EXPECT_EQ(sessions.merger.num_waiting(), 0u);
  ASSERT_EQ(sessions.merger.Reports().size(), 1u);
  EXPECT_NE(sessions.merger.Reports()[0].reason.find("/99 has no pose"), std::string::npos);
}

TEST(MapMerger, RefusesMatchesThatFitNoSimilarity) {
  Sessions sessions;
  PlaceMatch match = TrueOverlap(sessions.two, 8, 8);
  Rng rng(5);
  for (FeatureMatch& inlier : match.pairs[0].inliers) {
    inlier.a = rng.UniformInt(static_cast<uint32_t>(sessions.two.a[8].tracks.size()));
  }
  const std::string before = sessions.Bytes();
  sessions.merger.Add(match, sessions.table);
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.merger.Reports()[0].verdict, MergeVerdict::kRefused);
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapMerger, RefusesAWrongPlaceThoughItsMatchesFit) {
  // The matches of frame 8 given as those of the same points moved aside: a repeated object.
  const TwoDrives two = MakeTwoDrives();
  Sessions sessions(two);
  const Sim3 aside{
      1.0, Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY())), {1.0, 0.0, 0.5}};
  sessions.merger.Add(TrueOverlap(two, 8, 8), sessions.table);
  ASSERT_TRUE(sessions.InOneMap());
  Sessions wrong(two);
  wrong.b = MappedSession(two, true, aside);
  const Session moved = wrong.b;
  for (const auto& [index, frame] : moved.keyframes()) {
    // Poses elsewhere than where the landmarks say: what should be visible is not there.
    wrong.b.SetPose(index, TransformCamera(Inverse(aside), frame.cam_from_session));
  }
  wrong.merger.Add(TrueOverlap(two, 8, 8), wrong.table);
  EXPECT_FALSE(wrong.InOneMap()) << wrong.merger.Reports()[0].reason;
}

TEST(MapMerger, KeepsAMatchOnOneSpotProvisionalUntilAnotherConfirmsIt) {
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
  guarded.merger.Add(poster(3, 1.0), guarded.table);
  EXPECT_FALSE(guarded.InOneMap());
  EXPECT_EQ(guarded.merger.Reports()[0].verdict, MergeVerdict::kProvisional);
  guarded.merger.Add(poster(4, 1.0), guarded.table);  // the same landmarks again: no confirmation
  EXPECT_FALSE(guarded.InOneMap());
}

TEST(MapMerger, ClosesALoopWithoutMovingASession) {
  Sessions sessions;
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  sessions.merger.Add(TrueOverlap(sessions.two, 3, 3), sessions.table);
  const std::vector<MergeReport> reports = sessions.merger.Reports();
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[1].kind, MergeKind::kLoop);
  EXPECT_EQ(reports[1].verdict, MergeVerdict::kAccepted);
  EXPECT_EQ(sessions.merger.PlaceOf(sessions.b.id()).revision, 1u);
}

// As a restarted place recognition says it.
TEST(MapMerger, IgnoresAMatchThatIsSaidAgain) {
  Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  const std::string before = sessions.Bytes();
  PlaceMatch turned = TrueOverlap(sessions.two, 8, 8);  // the other frame asks
  std::swap(turned.query, turned.pairs[0].other);
  for (FeatureMatch& inlier : turned.pairs[0].inliers) std::swap(inlier.a, inlier.b);
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  sessions.merger.Add(turned, sessions.table);
  EXPECT_EQ(sessions.merger.num_repeated(), 2u);
  EXPECT_EQ(sessions.merger.Reports().size(), 1u);
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapMerger, IgnoresAMatchThatIsSaidAgainWhileTheFirstWaits) {
  Sessions sessions;
  sessions.b.SetWeak(8, true);
  for (int i = 0; i < 2; ++i) {
    sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  }
  EXPECT_EQ(sessions.merger.num_waiting(), 1u);
  EXPECT_EQ(sessions.merger.num_repeated(), 1u);
}

TEST(MapMerger, HearsAgainAMatchThatWaitedInVain) {
  Sessions sessions;
  sessions.b.SetWeak(8, true);
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  sessions.merger.GiveUpWaiting();
  sessions.b.SetWeak(8, false);
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.merger.num_repeated(), 0u);
}

TEST(MapMerger, MergesOnlyByRequestWhereAutomaticIsOff) {
  MergeOptions merge;
  merge.automatic = false;
  Sessions sessions(MakeTwoDrives(), WithMerge(merge));
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  EXPECT_FALSE(sessions.InOneMap());
  const MergeReport report =
      sessions.merger.Merge(sessions.a.id(), sessions.b.id(), false, sessions.table);
  EXPECT_EQ(report.verdict, MergeVerdict::kAccepted) << report.reason;
  EXPECT_TRUE(sessions.InOneMap());
}

TEST(MapMerger, SaysWhyARequestCannotBeMet) {
  Sessions sessions;
  const MergeReport none =
      sessions.merger.Merge(sessions.a.id(), sessions.b.id(), true, sessions.table);
  EXPECT_EQ(none.verdict, MergeVerdict::kRefused);
  EXPECT_NE(none.reason.find("no overlap"), std::string::npos);
  EXPECT_TRUE(sessions.merger.Unmerge(sessions.a.id(), sessions.table).empty());
}

TEST(MapMerger, UndoesAForcedMergeToTheByte) {
  Sessions sessions;
  const std::string before = sessions.Bytes();
  sessions.merger.MergeAt(sessions.a.id(), sessions.b.id(), {}, sessions.table);
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.merger.Unmerge(sessions.b.id(), sessions.table).size(), 1u);
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.Bytes(), before);
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  EXPECT_FALSE(sessions.InOneMap()) << "a place match joined what a request had separated";
}

TEST(MapMerger, UndoesAnAdjustedMergeToTheByte) {
  Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
  const std::string before = sessions.Bytes();
  sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
  ASSERT_TRUE(sessions.InOneMap());
  EXPECT_NE(sessions.Bytes(), before);
  sessions.merger.Unmerge(sessions.b.id(), sessions.table);
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapMerger, GivesTheSameBytesTwice) {
  std::string bytes[2];
  for (std::string& run : bytes) {
    Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
    sessions.merger.Add(TrueOverlap(sessions.two, 8, 8), sessions.table);
    sessions.merger.Add(TrueOverlap(sessions.two, 3, 3), sessions.table);
    sessions.merger.AdjustFinally(sessions.table);
    run = sessions.Bytes();
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

}  // namespace
}  // namespace rovio_sfm
