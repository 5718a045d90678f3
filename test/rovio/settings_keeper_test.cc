#include "rovio_sfm/rovio/settings_keeper.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

using Step = SettingsKeeper::Step;
constexpr int64_t kSecond = 1000000000;

SomeSettings OtherSettings() {
  SomeSettings settings{CameraSettings{}};
  settings.resolution = 2;
  return settings;
}

TEST(SettingsKeeper, AsksOnceAndWaitsUntilTheRobotAgrees) {
  SettingsKeeper keeper(CameraSettings{});
  EXPECT_EQ(keeper.Next(OtherSettings(), 0), Step::kRequest);
  keeper.MarkRequested(true, 0);
  EXPECT_EQ(keeper.Next(OtherSettings(), 1 * kSecond), Step::kNothing);
  EXPECT_EQ(keeper.Next(SomeSettings(CameraSettings{}), 2 * kSecond), Step::kAgreed);
  EXPECT_EQ(keeper.Next(OtherSettings(), 3 * kSecond), Step::kNothing);
}

TEST(SettingsKeeper, FindsOutThatTheRobotIgnoredIt) {
  SettingsKeeper keeper(CameraSettings{});
  keeper.Next(OtherSettings(), 0);
  keeper.MarkRequested(true, 0);
  EXPECT_EQ(keeper.Next(OtherSettings(), 6 * kSecond), Step::kRefused);
  EXPECT_EQ(keeper.Next(OtherSettings(), 7 * kSecond), Step::kNothing);
}

TEST(SettingsKeeper, AsksAgainWhenTheRequestWasLost) {
  SettingsKeeper keeper(CameraSettings{});
  EXPECT_EQ(keeper.Next(OtherSettings(), 0), Step::kRequest);
  keeper.MarkRequested(false, 0);
  EXPECT_EQ(keeper.Next(OtherSettings(), 1 * kSecond), Step::kRequest);
}

TEST(SettingsKeeper, AsksOnceForWhatTheRobotDoesNotTellAndTakesItAsGranted) {
  SettingsKeeper keeper(CameraSettings{});
  SomeSettings present{CameraSettings{}};
  present.frame_rate.reset();
  EXPECT_EQ(keeper.Next(present, 0), Step::kRequest);
  keeper.MarkRequested(true, 0);
  EXPECT_EQ(keeper.Next(present, 1 * kSecond), Step::kAgreed);
  EXPECT_EQ(Describe(present), "resolution 3, compression 2, frame_rate ?, brightness 6");
}

TEST(SettingsKeeper, WishesForWhatTheRobotHadLastWhenItWasAway) {
  SettingsKeeper keeper(CameraSettings{});
  EXPECT_EQ(keeper.Next(SomeSettings(CameraSettings{}), 0), Step::kAgreed);
  EXPECT_EQ(keeper.Next(OtherSettings(), 1 * kSecond), Step::kNothing);  // a service asked for them
  keeper.BeginAgain();
  EXPECT_EQ(keeper.Next(OtherSettings(), 2 * kSecond), Step::kAgreed);
  keeper.BeginAgain();
  EXPECT_EQ(keeper.Next(SomeSettings(CameraSettings{}), 3 * kSecond), Step::kRequest);
  EXPECT_EQ(keeper.Wanted().resolution, 2);
}

TEST(SettingsKeeper, WishesForWhatWasRefusedAgainWhenTheRobotWasAway) {
  SettingsKeeper keeper(CameraSettings{});
  keeper.Next(OtherSettings(), 0);
  keeper.MarkRequested(true, 0);
  EXPECT_EQ(keeper.Next(OtherSettings(), 6 * kSecond), Step::kRefused);
  EXPECT_EQ(keeper.Next(OtherSettings(), 7 * kSecond), Step::kNothing);
  keeper.BeginAgain();
  EXPECT_EQ(keeper.Next(OtherSettings(), 8 * kSecond), Step::kRequest);
  EXPECT_EQ(keeper.Wanted().resolution, CameraSettings{}.resolution);
}

// Every request wears out its flash.
TEST(SettingsKeeper, AsksNoSecondTimeForWhatTheRobotDoesNotTell) {
  SettingsKeeper keeper(CameraSettings{});
  SomeSettings present{CameraSettings{}};
  present.frame_rate.reset();
  EXPECT_EQ(keeper.Next(present, 0), Step::kRequest);
  keeper.MarkRequested(true, 0);
  EXPECT_EQ(keeper.Next(present, 1 * kSecond), Step::kAgreed);
  keeper.BeginAgain();
  EXPECT_EQ(keeper.Next(present, 2 * kSecond), Step::kAgreed);
}

TEST(SettingsKeeper, LeavesTheRobotAloneWhenNothingIsWanted) {
  SettingsKeeper keeper(std::nullopt);
  EXPECT_EQ(keeper.Next(OtherSettings(), 0), Step::kNothing);
}

}  // namespace
}  // namespace rovio_sfm
