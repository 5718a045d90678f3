#include "rovio_sfm/rovio/rovio_client.h"

#include <gtest/gtest.h>

#include "rovio/fake_http_transport.h"

namespace rovio_sfm {
namespace {

constexpr char kSuccess[] = "Cmd = nav\nresponses = 0\n";

class RovioClientTest : public testing::Test {
 protected:
  FakeHttpTransport robot_;
  RovioClient client_{&robot_};
};

TEST_F(RovioClientTest, DrivesAndReadsTheAnswer) {
  const std::string target = DriveTarget(DriveCode::kForward, 3);
  robot_.Answer(target, FakeHttpTransport::Ok(kSuccess));
  EXPECT_TRUE(client_.Drive({DriveCode::kForward, 3}).IsOk());
  EXPECT_EQ(robot_.targets, (std::vector<std::string>{target}));
}

TEST_F(RovioClientTest, StopsTwiceOverAndOneIsEnough) {
  robot_.Answer(DriveTarget(DriveCode::kStop, 0), FakeHttpTransport::Ok(kSuccess));
  EXPECT_TRUE(client_.Drive({}).IsOk());
  EXPECT_EQ(robot_.targets,
            (std::vector<std::string>{StopMotionTarget(), DriveTarget(DriveCode::kStop, 0)}));
}

TEST_F(RovioClientTest, TakesNo200ForASuccess) {
  robot_.Answer(DockTarget(), FakeHttpTransport::Ok("Cmd = nav\nresponses = 5\n"));
  robot_.Answer(DockTarget(), FakeHttpTransport::Ok(""));
  robot_.Answer(DockTarget(), FakeHttpTransport::Ok("Version = 5.03\n"));
  const RobotOutcome refused = client_.Dock();
  EXPECT_EQ(refused.fault, RobotFault::kRefused);
  EXPECT_EQ(refused.message, "no NorthStar signal");
  EXPECT_EQ(client_.Dock().fault, RobotFault::kMalformed);
  EXPECT_EQ(client_.Dock().fault, RobotFault::kMalformed);
}

TEST_F(RovioClientTest, TellsTheKindsOfFaultsApart) {
  robot_.Answer(DockTarget(), FakeHttpTransport::Status(401));
  robot_.Answer(DockTarget(), FakeHttpTransport::Status(500));
  robot_.Answer(DockTarget(), FakeHttpTransport::Fault(HttpFault::kTimeout));
  EXPECT_EQ(client_.Dock().fault, RobotFault::kDenied);
  EXPECT_EQ(client_.Dock().fault, RobotFault::kStatus);
  EXPECT_EQ(client_.Dock().fault, RobotFault::kLink);
}

TEST_F(RovioClientTest, GivesAReportOnlyWhenItCouldBeRead) {
  robot_.Answer(McuReportTarget(),
                FakeHttpTransport::Ok("Cmd = nav\nresponses = 0E0100000000000000000003CB744B\n"));
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Ok("Cmd = nav\nresponses = 0E01\n"));
  EXPECT_TRUE(client_.GetMcuReport().value);
  const RobotReply<McuReport> damaged = client_.GetMcuReport();
  EXPECT_FALSE(damaged.value);
  EXPECT_EQ(damaged.outcome.fault, RobotFault::kMalformed);
}

TEST_F(RovioClientTest, SendsOnlySettingsThatDiffer) {
  CameraSettings present, wanted;
  present.resolution = 2;
  present.frame_rate = 30;
  robot_.Answer(ResolutionTarget(wanted.resolution), FakeHttpTransport::Ok(""));
  robot_.Answer(FrameRateTarget(wanted.frame_rate), FakeHttpTransport::Ok(""));
  EXPECT_TRUE(client_.RequestSettings(SomeSettings(wanted), SomeSettings(present)).IsOk());
  EXPECT_EQ(robot_.targets, (std::vector<std::string>{FrameRateTarget(wanted.frame_rate),
                                                      ResolutionTarget(wanted.resolution)}));
}

TEST_F(RovioClientTest, SendsSettingsThatTheRobotDoesNotTell) {
  const CameraSettings wanted;
  SomeSettings present(wanted);
  present.resolution.reset();
  robot_.Answer(ResolutionTarget(wanted.resolution), FakeHttpTransport::Ok(""));
  EXPECT_TRUE(client_.RequestSettings(SomeSettings(wanted), present).IsOk());
  EXPECT_EQ(robot_.targets, (std::vector<std::string>{ResolutionTarget(wanted.resolution)}));
}

TEST_F(RovioClientTest, CapsAStill) {
  robot_.AnswerStill(FakeHttpTransport::Ok(std::string(2000, 'x')));
  EXPECT_FALSE(client_.GetStill(1000).value);
  EXPECT_TRUE(client_.GetStill(3000).value);
}

}  // namespace
}  // namespace rovio_sfm
