#include "rovio_sfm/sim/robot/simulated_robot.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

constexpr int64_t kSecond_ns = 1'000'000'000;

class SimulatedRobots : public testing::Test {
 protected:
  static SimulatedRobotOptions Options() {
    SimulatedRobotOptions options;
    options.start = {0.6, 1.5, 0.0};
    options.render.samples_per_side = 1;
    return options;
  }

  const World world_{SmallWorldSpec()};
  SimulatedRobot robot_{world_, Options()};
};

TEST_F(SimulatedRobots, DrivesAndTellsTheTruth) {
  robot_.AdvanceTo(kSecond_ns);
  robot_.Drive({1, 1, {}, kSecond_ns});
  robot_.AdvanceTo(3 * kSecond_ns);
  const TruePose pose = robot_.ReadTruth();
  EXPECT_NEAR(pose.world_from_base.translation.x(), 0.9, 0.03);
  EXPECT_NEAR(pose.world_from_camera.translation.z(), 0.28, 0.01);
  EXPECT_GT(robot_.ReadMcu().left.ticks, 90);
  EXPECT_EQ(robot_.ReadMcu().left.ticks, 0);
}

TEST_F(SimulatedRobots, StopsBeforeTheWall) {
  robot_.AdvanceTo(0);
  robot_.Drive({2, 1, {}, 10 * kSecond_ns});
  robot_.AdvanceTo(10 * kSecond_ns);
  EXPECT_GT(robot_.ReadTruth().world_from_base.translation.x(), 0.15);
}

TEST_F(SimulatedRobots, MovesItsHeadInAboutASecond) {
  robot_.AdvanceTo(0);
  robot_.MoveHead(HeadPosition::kDown);
  robot_.AdvanceTo(kSecond_ns / 2);
  EXPECT_NEAR(robot_.PeekMcu().head_position, 128, 3);
  robot_.AdvanceTo(2 * kSecond_ns);
  EXPECT_EQ(robot_.PeekMcu().head_position, 203);
}

TEST_F(SimulatedRobots, SendsPicturesOfTheAskedSize) {
  robot_.AdvanceTo(0);
  CameraSettings settings;
  settings.resolution = 1;
  const auto first = robot_.Capture(kSecond_ns, settings);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->time_ns, kSecond_ns);
  EXPECT_EQ(cv::imdecode(first->jpeg, cv::IMREAD_COLOR).size(), cv::Size(320, 240));
  EXPECT_EQ(robot_.Capture(kSecond_ns, settings)->jpeg, first->jpeg);
}

TEST_F(SimulatedRobots, SeesTheSameWhetherOrNotSomebodyLookedBefore) {
  CameraSettings settings;
  settings.resolution = 0;
  SimulatedRobot other(world_, Options());
  for (SimulatedRobot* robot : {&robot_, &other}) robot->AdvanceTo(0);
  robot_.Capture(kSecond_ns, settings);
  const auto rested = robot_.Capture(2 * kSecond_ns, settings);
  EXPECT_EQ(rested->jpeg, other.Capture(2 * kSecond_ns, settings)->jpeg);
  robot_.Drive({1, 1, {}, kSecond_ns});
  robot_.AdvanceTo(3 * kSecond_ns);
  EXPECT_NE(robot_.Capture(3 * kSecond_ns, settings)->jpeg, rested->jpeg);
}

TEST_F(SimulatedRobots, SeesObstaclesOnlyWithInfrared) {
  SimulatedRobotOptions near = Options();
  near.start = {1.5, 1.0, 0.0};
  SimulatedRobot robot(world_, near);
  robot.AdvanceTo(0);
  EXPECT_FALSE(robot.PeekMcu().obstacle);
  robot.SwitchInfrared(true);
  EXPECT_TRUE(robot.PeekMcu().obstacle);
}

TEST_F(SimulatedRobots, RemembersHomeAndLight) {
  robot_.SaveHome();
  robot_.SwitchHeadlight(true);
  EXPECT_TRUE(robot_.ReadNav().home_saved);
  EXPECT_TRUE(robot_.PeekMcu().headlight);
}

TEST(SimulatedRobotOptions, NamesTheBadField) {
  SimulatedRobotOptions options;
  options.shutter_s = -1.0;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("shutter_s"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm::sim
