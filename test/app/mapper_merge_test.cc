// Merging and undoing while drives go on, as the mapping node does it.
#include <gtest/gtest.h>

#include <future>
#include <map>

#include "merging/two_drives.h"
#include "rovio_sfm/app/mapper.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kBefore = 12;  // frames of each drive before the merge
constexpr uint32_t kAfter = 20;   // of the second drive since

// Two drives under a mapper, the second one still on its way.
struct Driving {
  explicit Driving(const MapOptions& options = {})
      : two(MakeTwoDrives(WorldOptions())), mapper(options, &store, &executor) {
    for (uint32_t i = 0; i < kBefore; ++i) Add(two.a[i]);
    for (uint32_t i = 0; i < kBefore; ++i) Add(two.b[i]);
  }

  static SyntheticDriveOptions WorldOptions() {
    SyntheticDriveOptions options = TwoDrivesOptions(0.5);
    options.world.num_cams = 2 * (kBefore + kAfter);
    options.world.step = 0.1;
    return options;
  }

  void Add(const FrameEvent& event) {
    store.Put(event.id, event.features);
    mapper.Add(event);
  }

  void DriveOn() {
    for (uint32_t i = kBefore; i < kBefore + kAfter; ++i) Add(two.b[i]);
  }

  TwoDrives two;
  MemoryFrameStore store;
  Executor executor{0};
  Mapper mapper;
};

// The numbers of every pose, by session and frame.
using Poses = std::map<std::pair<uint32_t, uint32_t>, std::vector<double>>;

Poses PosesOf(const MapSnapshot& snapshot) {
  Poses poses;
  for (const SessionSnapshot& session : snapshot.sessions) {
    for (const auto& block : session.frames) {
      for (const FrameSnapshot& frame : *block) {
        const Rigid3& pose = frame.cam_from_session;
        std::vector<double>& numbers = poses[{session.id.value, frame.index}];
        numbers.assign(pose.rotation.coeffs().data(), pose.rotation.coeffs().data() + 4);
        numbers.insert(numbers.end(), pose.translation.data(), pose.translation.data() + 3);
      }
    }
  }
  return poses;
}

// Those of the poses that have a namesake among the others.
Poses Common(const Poses& poses, const Poses& others) {
  Poses common;
  for (const auto& entry : poses) {
    if (others.count(entry.first) != 0) common.insert(entry);
  }
  return common;
}

// The greatest error of the second drive's cameras, by the best similarity.
double ErrorOfSecond(const SessionSnapshot& session, const TwoDrives& two) {
  SyntheticWorld seen = two.world;
  seen.cams_from_map.clear();
  for (uint32_t i = 0; i < two.b.size(); ++i) {
    seen.cams_from_map.push_back(two.world.cams_from_map[CameraOf(true, i)]);
  }
  const auto error = MeasureTrajectory(session, seen);
  return error ? error->max_distance : 1e9;
}

TEST(MapperMerge, AForcedWrongMergeLeavesNoTraceOnceUndone) {
  Driving driving;
  const auto before = driving.mapper.Snapshot();
  ASSERT_EQ(before->sessions.size(), 2u);
  const SessionId first = before->sessions[0].id, second = before->sessions[1].id;
  const Sim3 wrong{
      0.4, Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitY())), {5.0, 0.0, 1.0}};
  ASSERT_EQ(driving.mapper.MergeAt(first, second, wrong).verdict, MergeVerdict::kAccepted);
  driving.DriveOn();
  EXPECT_EQ(driving.mapper.Snapshot()->sessions[1].map, before->sessions[0].map);
  ASSERT_EQ(driving.mapper.Unmerge(second).size(), 1u);
  const auto after = driving.mapper.Snapshot();
  ASSERT_EQ(after->sessions.size(), 2u);
  EXPECT_EQ(after->sessions[0].map, before->sessions[0].map);
  EXPECT_EQ(after->sessions[1].map, before->sessions[1].map);
  EXPECT_EQ(Common(PosesOf(*after), PosesOf(*before)), PosesOf(*before));
  EXPECT_EQ(PosesOf(*after).size(), PosesOf(*before).size() + kAfter);
  EXPECT_LT(ErrorOfSecond(after->sessions[1], driving.two), 0.05);
}

TEST(MapperMerge, AnAdjustedMergeLeavesNoTraceOnceUndone) {
  MapOptions options;
  options.merge.automatic = false;
  Driving driving(options);
  driving.mapper.Add(TrueOverlap(driving.two, 8, 8));
  const auto before = driving.mapper.Snapshot();
  const SessionId first = before->sessions[0].id, second = before->sessions[1].id;
  ASSERT_EQ(driving.mapper.Merge(first, second, true).verdict, MergeVerdict::kAccepted);
  driving.DriveOn();
  EXPECT_NE(Common(PosesOf(*driving.mapper.Snapshot()), PosesOf(*before)), PosesOf(*before));
  ASSERT_EQ(driving.mapper.Unmerge(second).size(), 1u);
  const auto after = driving.mapper.Snapshot();
  EXPECT_FALSE(after->sessions[0].map == after->sessions[1].map);
  EXPECT_EQ(Common(PosesOf(*after), PosesOf(*before)), PosesOf(*before));
  EXPECT_EQ(PosesOf(*after).size(), PosesOf(*before).size() + kAfter);
  EXPECT_LT(ErrorOfSecond(after->sessions[1], driving.two), 0.05);
}

TEST(MapperMerge, DrivesGoOnInOneMapAfterATrueMerge) {
  Driving driving;
  driving.mapper.Add(TrueOverlap(driving.two, 8, 8));
  driving.DriveOn();
  driving.mapper.Finish();
  const auto snapshot = driving.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 2u);
  EXPECT_EQ(snapshot->sessions[0].map, snapshot->sessions[1].map);
  EXPECT_LT(ErrorOfSecond(snapshot->sessions[1], driving.two), 0.05);
}

TEST(MapperMerge, SaysAtTheEndWhatWaitedInVain) {
  Driving driving;
  PlaceMatch match = TrueOverlap(driving.two, 8, 8);
  match.query.index = 999;
  driving.mapper.Add(match);
  EXPECT_TRUE(driving.mapper.MergeReports().empty());
  driving.mapper.Finish();
  ASSERT_EQ(driving.mapper.MergeReports().size(), 1u);
  EXPECT_EQ(driving.mapper.MergeReports()[0].verdict, MergeVerdict::kRefused);
  EXPECT_NE(driving.mapper.MergeReports()[0].reason.find("/999 has no pose"), std::string::npos);
}

// Frame `query` and frame `other` of the second drive show the same place.
PlaceMatch OverlapWithin(const TwoDrives& two, uint32_t other, uint32_t query) {
  PlaceMatch match;
  match.query = two.b[query].id;
  OverlapPair pair;
  pair.other = two.b[other].id;
  pair.verdict = PairVerdict::kGeneral;
  pair.inliers = TrueMatches(two.world, CameraOf(true, other), CameraOf(true, query));
  match.pairs.push_back(pair);
  return match;
}

// Three sessions, each of which overlaps the two others: the loops that tie one to the others go
// with its merge.
TEST(MapperMerge, ASessionThatOverlapsAllOthersIsOutAtTheFirstCall) {
  SyntheticDriveOptions options = TwoDrivesOptions();
  options.world.num_cams = 48;
  options.world.step = 0.1;
  const TwoDrives two = MakeTwoDrives(options);
  MemoryFrameStore store;
  Executor executor{0};
  Mapper mapper{{}, &store, &executor};
  for (const FrameEvent& event : two.a) mapper.Add(event);
  for (size_t i = 0; i < two.b.size(); ++i) {
    if (i == 12) mapper.FinishSession(two.b[0].id.drive);
    mapper.Add(two.b[i]);
  }
  mapper.Finish();
  mapper.Add(TrueOverlap(two, 6, 6));
  mapper.Add(TrueOverlap(two, 18, 18));
  mapper.Add(OverlapWithin(two, 10, 13));
  auto snapshot = mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 3u);
  ASSERT_EQ(snapshot->sessions[2].map, snapshot->sessions[0].map);
  EXPECT_GE(mapper.Unmerge(SessionId{3}).size(), 2u) << "its merge, and its loops with session 2";
  snapshot = mapper.Snapshot();
  EXPECT_EQ(snapshot->sessions[1].map, snapshot->sessions[0].map);
  EXPECT_FALSE(snapshot->sessions[2].map == snapshot->sessions[0].map);
}

// Live: as long as the solving takes, frames and matches go on, and its result comes when it is
// there.
TEST(MapperMerge, NothingWaitsForAnAdjustmentThatIsNotReady) {
  const TwoDrives two = MakeTwoDrives(Driving::WorldOptions());
  MemoryFrameStore store;
  Executor executor{1};
  std::promise<void> solver_is_free;
  executor.Submit([](const std::shared_future<void>& free) { free.wait(); },
                  solver_is_free.get_future().share());
  Mapper mapper({}, &store, &executor, nullptr, ResultTiming::kWhenReady);
  for (uint32_t i = 0; i < kBefore; ++i) mapper.Add(two.a[i]);
  for (uint32_t i = 0; i < kBefore; ++i) mapper.Add(two.b[i]);
  mapper.Add(TrueOverlap(two, 8, 8));
  for (uint32_t i = kBefore; i < kBefore + kAfter; ++i) mapper.Add(two.b[i]);
  ASSERT_EQ(mapper.MergeReports()[0].verdict, MergeVerdict::kAccepted);
  EXPECT_FALSE(mapper.ApplyDueResults());
  EXPECT_FALSE(mapper.MergeReports()[0].error_after_px);
  solver_is_free.set_value();
  executor.Submit([] {}).wait();  // behind the adjustment
  EXPECT_TRUE(mapper.ApplyDueResults());
  EXPECT_TRUE(mapper.MergeReports()[0].error_after_px);
  EXPECT_LT(ErrorOfSecond(mapper.Snapshot()->sessions[1], two), 0.05);
}

}  // namespace
}  // namespace rovio_sfm
