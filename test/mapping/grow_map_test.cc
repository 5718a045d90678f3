#include "rovio_sfm/mapping/grow_map.h"

#include <gtest/gtest.h>

#include <utility>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

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
    return RejoinFrame(event, place, {}, store, nullptr, &table);
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
  ASSERT_EQ(RejoinFrame(light, {}, {}, store, nullptr, &table), &session);
  const LightFrame& frame = session.light_frames().at(5);
  EXPECT_LT(
      PoseDistance(frame.cam_from_reference * session.keyframe(frame.reference).cam_from_session,
                   drive.world.cams_from_map[5]),
      1e-5);
}

}  // namespace
}  // namespace rovio_sfm
