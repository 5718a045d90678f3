#include "rovio_sfm/sim/http/server_context.h"

#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

TEST(TakeSnapshot, ShowsRobotSettingsAndLastPicture) {
  FaceFixture face;
  face.robot.nav.x = 11;
  face.context.settings.With([](RobotSettings& settings) { settings.SetResolution(3); });
  EXPECT_EQ(TakeSnapshot(face.context, Privilege::kUser).picture_index, 999999u);
  face.context.frames.Publish(face.context.frames.BeginCapture(), {1, 2, 3});
  const RobotSnapshot snapshot = TakeSnapshot(face.context, Privilege::kUser);
  EXPECT_EQ(snapshot.nav.x, 11);
  EXPECT_EQ(snapshot.settings.resolution, 3);
  EXPECT_EQ(snapshot.caller_privilege, Privilege::kUser);
  EXPECT_EQ(snapshot.picture_index, 0u);
  EXPECT_EQ(snapshot.picture_bytes, 3u);
}

TEST(TakeSnapshot, ShowsTheQuirksReadings) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("battery", 101));
  ASSERT_TRUE(face.SetQuirk("wifi", 150));
  const RobotSnapshot snapshot = TakeSnapshot(face.context, Privilege::kUser);
  EXPECT_EQ(snapshot.mcu.battery, 101);
  EXPECT_EQ(snapshot.wifi_signal_strength, 150);
}

TEST(HttpFaceOptions, NamesOptionValueAndBound) {
  HttpFaceOptions options;
  options.drive_hold_ns = 0;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "face.drive_hold_ns = 0: expected 1 to 3600000000000");
}

}  // namespace
}  // namespace rovio_sfm::sim
