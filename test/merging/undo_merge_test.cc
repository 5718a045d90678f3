#include "rovio_sfm/merging/undo_merge.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

// The first frames of a session.
Session FirstFrames(const Session& session, uint32_t count) {
  Session first = session;
  for (const auto& [index, frame] : session.keyframes()) {
    if (index >= count) first.RemoveKeyframe(index);
  }
  return first;
}

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

TEST(RestoreSession, GivesOldFramesTheirBytesAndNewOnesTheirPlace) {
  const TwoDrives two = MakeTwoDrives();
  const Session whole = MappedSession(two, true, {});
  const Session before = FirstFrames(whole, 10);
  Session now = MappedSession(two, true, OtherGauge());  // as a merge may have left it
  now.set_odometry_delay(OdometryDelay{0.08, 0.01});     // of the robot, not of the merge
  RestoreSession(before, {}, &now);
  EXPECT_TRUE(now.odometry_delay().has_value());
  EXPECT_EQ(NumbersOf(now, 10), NumbersOf(before, 10));
  EXPECT_EQ(now.keyframes().size(), whole.keyframes().size());
  for (const auto& [index, frame] : now.keyframes()) {
    EXPECT_LT(PoseDistance(frame.cam_from_session, whole.keyframe(index).cam_from_session), 1e-5);
  }
  for (const auto& [id, landmark] : before.landmarks()) {
    EXPECT_EQ(now.landmarks().at(id).position, landmark.position);
  }
  EXPECT_EQ(CheckInvariants(now), "");
}

TEST(RestoreSession, IsExactWhereNothingCameSince) {
  const TwoDrives two = MakeTwoDrives();
  const Session before = MappedSession(two, true, {});
  Session now = MappedSession(two, true, OtherGauge());
  RestoreSession(before, {}, &now);
  EXPECT_EQ(BytesOf(now), BytesOf(before));
}

}  // namespace
}  // namespace rovio_sfm
