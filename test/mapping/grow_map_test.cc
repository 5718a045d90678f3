#include "rovio_sfm/mapping/grow_map.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

const auto kAlone = [](const Session&) { return std::vector<Sibling>{}; };
constexpr uint32_t kLost = 8;  // a keyframe in the middle of the drive

SyntheticDrive MakeDrive(const SyntheticDriveOptions& options) {
  SyntheticDrive drive = MakeSyntheticDrive(options);
  drive.events[kLost].pairs.clear();
  return drive;
}

// A session of all keyframes but the lost one.
struct Interrupted {
  explicit Interrupted(const SyntheticDriveOptions& options = {}) : drive(MakeDrive(options)) {
    Session whole = MappedDrive(drive);
    whole.RemoveKeyframe(kLost);
    session = &table.Adopt(std::move(whole));
  }

  const FrameEvent& lost() const { return drive.events[kLost]; }

  Session* Rejoin(const FrameEvent& event, const PlaceMatch& place = {}) {
    return RejoinFrame(event, place, {}, store, nullptr, kAlone, &table);
  }

  SyntheticDrive drive;
  MemoryFrameStore store = StoreOf(drive);
  SessionTable table;
  Session* session = nullptr;
};

TEST(RejoinFrame, PosesAKeyframeByItsTracks) {
  Interrupted setup;
  ASSERT_EQ(setup.Rejoin(setup.lost()), setup.session);
  const Keyframe& frame = setup.session->keyframe(kLost);
  EXPECT_LT(PoseDistance(frame.cam_from_session, setup.drive.world.cams_from_map[kLost]), 1e-5);
  EXPECT_GT(frame.num_observed, 50u);
  EXPECT_EQ(CheckInvariants(*setup.session), "");
}

TEST(RejoinFrame, PosesAKeyframeWithNewTracksByItsPlace) {
  SyntheticDriveOptions options;
  options.blind = {kLost};
  Interrupted setup(options);
  const size_t num_landmarks = setup.session->landmarks().size();
  EXPECT_EQ(setup.Rejoin(setup.lost()), nullptr);  // its tracks show nothing
  EXPECT_EQ(setup.session->keyframes().count(kLost), 0u);
  ASSERT_EQ(setup.Rejoin(setup.lost(), TruePlace(setup.drive, kLost, 3)), setup.session);
  const Keyframe& frame = setup.session->keyframe(kLost);
  EXPECT_LT(PoseDistance(frame.cam_from_session, setup.drive.world.cams_from_map[kLost]), 1e-5);
  EXPECT_GT(frame.num_observed, 50u);
  EXPECT_LE(setup.session->landmarks().size(), num_landmarks);  // theirs, none of its own
  EXPECT_EQ(CheckInvariants(*setup.session), "");
}

TEST(RejoinFrame, TakesNoWordOfPlacesThatAreWrong) {
  SyntheticDriveOptions options;
  options.blind = {kLost};
  Interrupted setup(options);
  PlaceMatch place = TruePlace(setup.drive, kLost, 3);
  auto& inliers = place.pairs[0].inliers;
  for (size_t i = 0; i < inliers.size() / 2; ++i) std::swap(inliers[i].b, inliers.rbegin()[i].b);
  EXPECT_EQ(setup.Rejoin(setup.lost(), place), nullptr);
  inliers = {{0, 100000}, {100000, 0}};  // features that are not there
  EXPECT_EQ(setup.Rejoin(setup.lost(), place), nullptr);
  place.pairs[0].other.drive.robot = "another";
  EXPECT_EQ(setup.Rejoin(setup.lost(), place), nullptr);
  EXPECT_EQ(setup.session->keyframes().count(kLost), 0u);
  EXPECT_EQ(CheckInvariants(*setup.session), "");
}

TEST(RejoinFrame, PosesALightFrame) {
  SyntheticDriveOptions options;
  options.light_frames = 1;
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  SessionTable table;
  Session& session = table.Adopt(MappedDrive(drive));
  const MemoryFrameStore store = StoreOf(drive);
  const FrameEvent& light = drive.events[5];
  ASSERT_EQ(light.kind, FrameKind::kLight);
  ASSERT_EQ(RejoinFrame(light, {}, {}, store, nullptr, kAlone, &table), &session);
  const LightFrame& frame = session.light_frames().at(5);
  EXPECT_LT(
      PoseDistance(frame.cam_from_reference * session.keyframe(frame.reference).cam_from_session,
                   drive.world.cams_from_map[5]),
      1e-5);
}

// A session of the drive's keyframes that knows the landmarks of every second track.
Session HalfOf(const SyntheticDrive& drive, uint32_t id, const Sim3& session_from_map) {
  Session session({id}, drive.events[0].id.drive, drive.world.camera);
  for (size_t i = 0; i < drive.events.size(); ++i) {
    if (drive.events[i].kind == FrameKind::kLight) continue;
    const Rigid3 pose = TransformCamera(session_from_map, drive.world.cams_from_map[i]);
    session.AddKeyframe(drive.events[i].id.index, MakeKeyframe(drive.events[i], pose, {}));
  }
  for (const auto& [track_id, track] : session.tracks()) {
    if (track.members.size() < 2 || track_id % 2 != id % 2) continue;
    const Eigen::Vector3d& point = drive.world.points[PointOf(drive, track.members[0])];
    session.AddLandmark(track_id, session_from_map * point, {}, track.members);
  }
  return session;
}

// Keeps six tracks of the frame that each of the sessions has landmarks of.
void ShowSixOfEach(const std::vector<const Session*>& sessions, FrameEvent* event) {
  std::vector<int> num_shown(sessions.size(), 0);
  for (TrackId& track : event->tracks) {
    bool is_kept = false;
    for (size_t i = 0; i < sessions.size() && track != 0; ++i) {
      is_kept |= sessions[i]->FindLandmark(track) != nullptr && ++num_shown[i] <= 6;
    }
    if (!is_kept) track = 0;
  }
}

TEST(RejoinFrame, PosesALightFrameByWhatSiblingsLend) {
  SyntheticDriveOptions options;
  options.light_frames = 1;
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()));
  const Sim3 second_from_first{0.4, turn, {1.0, 2.0, 3.0}};
  SessionTable table;
  Session& first = table.Adopt(HalfOf(drive, 1, {}));
  const Session& second = table.Adopt(HalfOf(drive, 2, second_from_first));
  const MemoryFrameStore store = StoreOf(drive);
  FrameEvent light = drive.events[5];
  ShowSixOfEach({&first, &second}, &light);
  EXPECT_EQ(RejoinFrame(light, {}, {}, store, nullptr, kAlone, &table), nullptr);
  const auto siblings_of = [&](const Session& session) {
    return &session == &first ? std::vector<Sibling>{{&second, Inverse(second_from_first)}}
                              : std::vector<Sibling>{};
  };
  ASSERT_EQ(RejoinFrame(light, {}, {}, store, nullptr, siblings_of, &table), &first);
  const LightFrame& frame = first.light_frames().at(5);
  EXPECT_EQ(frame.num_inliers, 12u);
  EXPECT_LT(
      PoseDistance(frame.cam_from_reference * first.keyframe(frame.reference).cam_from_session,
                   drive.world.cams_from_map[5]),
      1e-5);
}

}  // namespace
}  // namespace rovio_sfm
