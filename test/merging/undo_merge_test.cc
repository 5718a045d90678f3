#include "rovio_sfm/merging/undo_merge.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

std::vector<double> NumbersOf(const Session& session, uint32_t num_frames) {
  std::vector<double> numbers;
  for (uint32_t i = 0; i < num_frames; ++i) {
    const Keyframe& frame = session.keyframe(i);
    for (const double x : frame.cam_from_session.translation) numbers.push_back(x);
    for (const double x : frame.cam_from_session.rotation.coeffs()) numbers.push_back(x);
    numbers.push_back(frame.num_observed);
  }
  return numbers;
}

// A session of ten frames, marked, then moved into another gauge and grown, as after a merge.
struct Grown {
  explicit Grown(const Sim3& now_from_whole) : now(whole), moved(now_from_whole) {
    for (const auto& [index, frame] : whole.keyframes()) {
      if (index >= 10) now.RemoveKeyframe(index);
    }
    before = BytesOf(now);
    numbers = NumbersOf(now, 10);
    mark = now.Mark();
    const Session marked = now;
    for (const auto& [index, frame] : marked.keyframes()) {
      now.SetPose(index, TransformCamera(moved, frame.cam_from_session));
    }
    for (const auto& [id, landmark] : marked.landmarks()) {
      now.SetPosition(id, moved * landmark.position);
    }
  }

  void AddLaterFrames() {
    for (const auto& [index, frame] : whole.keyframes()) {
      if (index < 10) continue;
      Keyframe later = frame;
      later.cam_from_session = TransformCamera(moved, frame.cam_from_session);
      now.AddKeyframe(index, later);
    }
    for (const auto& [id, landmark] : whole.landmarks()) {
      if (now.landmarks().count(id) == 0) {
        now.AddLandmark(id, moved * landmark.position, {}, landmark.observations);
        continue;
      }
      for (const Observation& o : landmark.observations) {
        if (o.frame >= 10) now.AddObservation(id, o);
      }
    }
  }

  TwoDrives two = MakeTwoDrives();
  Session whole = MappedSession(two, true, {});
  Session now;
  Sim3 moved;
  std::string before;
  std::vector<double> numbers;
  uint32_t mark = 0;
};

TEST(RestoreSession, GivesOldFramesTheirBytesAndNewOnesTheirPlace) {
  Grown grown(OtherGauge());
  grown.AddLaterFrames();
  grown.now.set_odometry_delay(OdometryDelay{0.08, 0.01});  // of the robot, not of the merge
  RestoreSession(grown.mark, {}, &grown.now);
  EXPECT_TRUE(grown.now.odometry_delay().has_value());
  EXPECT_EQ(NumbersOf(grown.now, 10), grown.numbers);
  EXPECT_EQ(grown.now.keyframes().size(), grown.whole.keyframes().size());
  for (const auto& [index, frame] : grown.now.keyframes()) {
    EXPECT_FALSE(frame.weak);
    EXPECT_LT(PoseDistance(frame.cam_from_session, grown.whole.keyframe(index).cam_from_session),
              1e-5);
  }
  EXPECT_EQ(CheckInvariants(grown.now), "");
}

TEST(RestoreSession, IsExactWhereNothingCameSince) {
  Grown grown(OtherGauge());
  RestoreSession(grown.mark, {}, &grown.now);
  EXPECT_EQ(BytesOf(grown.now), grown.before);
}

// One point at which all cameras and landmarks stand tells no similarity.
TEST(RestoreSession, ResectsLaterFramesWhereTheStatesShareNoSimilarity) {
  Grown grown(OtherGauge());
  grown.AddLaterFrames();
  const Session now = grown.now;
  for (const auto& [id, landmark] : now.landmarks()) grown.now.SetPosition(id, {0.0, 0.0, 0.0});
  for (const auto& [index, frame] : now.keyframes()) grown.now.SetPose(index, {});
  RestoreSession(grown.mark, {}, &grown.now);
  EXPECT_EQ(NumbersOf(grown.now, 10), grown.numbers);
  ASSERT_EQ(grown.now.keyframes().size(), grown.whole.keyframes().size());
  for (const auto& [index, frame] : grown.now.keyframes()) {
    EXPECT_TRUE(frame.weak || PoseDistance(frame.cam_from_session,
                                           grown.whole.keyframe(index).cam_from_session) < 1e-5)
        << "frame " << index << " stands where nothing says that it does";
  }
  EXPECT_EQ(CheckInvariants(grown.now), "");
}

MergeEdit AcceptedEdit(uint32_t a, uint32_t b, MergeKind kind,
                       const std::vector<uint32_t>& marked) {
  MergeEdit edit;
  edit.report.kind = kind;
  edit.report.other_session = {a};
  edit.report.query_session = {b};
  for (const uint32_t session : marked) edit.marks[{session}] = 10 * b + session;
  return edit;
}

// 1-2, 4-5, 2-3, a loop 1-3, a loop within 3, then 3-4 join everything.
TEST(PlanUndo, TakesOutWhatIsTheSessionsAndRepeatsWhatStoodOnIt) {
  MergeList list;
  const auto accept = [&](MergeEdit edit) {
    list.Accept(AcceptedBy::kEvidence, &list.Keep(std::move(edit)));
  };
  accept(AcceptedEdit(1, 2, MergeKind::kMerge, {1, 2}));
  accept(AcceptedEdit(4, 5, MergeKind::kMerge, {4, 5}));
  accept(AcceptedEdit(2, 3, MergeKind::kMerge, {1, 2, 3}));
  accept(AcceptedEdit(1, 3, MergeKind::kLoop, {}));
  accept(AcceptedEdit(3, 3, MergeKind::kLoop, {}));
  accept(AcceptedEdit(3, 4, MergeKind::kMerge, {1, 2, 3, 4, 5}));
  const auto ids = [](const std::vector<MergeEdit*>& edits) {
    std::vector<uint32_t> numbers;
    for (const MergeEdit* edit : edits) numbers.push_back(edit->report.id);
    return numbers;
  };
  const UndoPlan third = PlanUndo({3}, &list);
  EXPECT_EQ(ids(third.undone), (std::vector<uint32_t>{3, 4, 6}));
  EXPECT_EQ(ids(third.repeated), std::vector<uint32_t>{5}) << "its own loop stays";
  EXPECT_EQ(third.marks.at({1}), 31u) << "as it was before session 3 came";
  EXPECT_EQ(third.marks.at({4}), 44u);
  const UndoPlan first = PlanUndo({1}, &list);
  EXPECT_EQ(ids(first.undone), (std::vector<uint32_t>{1, 4}));
  EXPECT_EQ(ids(first.repeated), (std::vector<uint32_t>{3, 5, 6}));
  EXPECT_EQ(first.marks.at({2}), 22u);
  EXPECT_EQ(first.marks.at({5}), 45u) << "the merge of 4 and 5 was made apart and stays";
  EXPECT_TRUE(PlanUndo({6}, &list).undone.empty());
}

}  // namespace
}  // namespace rovio_sfm
