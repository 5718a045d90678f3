#include "rovio_sfm/rovio/drive_loop.h"

#include <gtest/gtest.h>

#include <future>

#include "rovio/fake_http_transport.h"

namespace rovio_sfm {
namespace {

constexpr char kSuccess[] = "Cmd = nav\nresponses = 0\n";

void AnswerAll(FakeHttpTransport* robot, const HttpResponse& response) {
  robot->Answer(DriveTarget(DriveCode::kForward, 4), response);
  robot->Answer(StopMotionTarget(), response);
  robot->Answer(DriveTarget(DriveCode::kStop, 0), response);
}

TEST(DriveLoop, StopsTheRobotWhenItEnds) {
  FakeHttpTransport robot;
  AnswerAll(&robot, FakeHttpTransport::Ok(kSuccess));
  std::promise<void> sent;
  DriveLoop loop({}, &robot, [&sent](const DriveCommand&, const RobotOutcome& outcome) {
    EXPECT_TRUE(outcome.IsOk());
    sent.set_value();
  });
  loop.SetWish({0.21, 0, 0}, 0);
  sent.get_future().wait();
  EXPECT_TRUE(loop.IsMoving());
  loop.Shutdown();
  EXPECT_EQ(robot.targets.back(), DriveTarget(DriveCode::kStop, 0));
  EXPECT_FALSE(loop.IsMoving());
}

TEST(DriveLoop, SendsNothingWhenNobodyWishedAnything) {
  FakeHttpTransport robot;
  {
    DriveLoop loop({}, &robot, [](const DriveCommand&, const RobotOutcome&) {});
    loop.Tick(0);
  }
  EXPECT_TRUE(robot.targets.empty());
}

TEST(DriveLoop, AnUnreachableRobotIsReportedAndNotDrivenOn) {
  FakeHttpTransport robot;
  AnswerAll(&robot, FakeHttpTransport::Fault(HttpFault::kConnect));
  std::promise<RobotFault> fault;
  DriveLoop loop({}, &robot, [&fault](const DriveCommand& command, const RobotOutcome& outcome) {
    if (command.code == DriveCode::kForward) fault.set_value(outcome.fault);
  });
  loop.SetWish({0.21, 0, 0}, 0);
  EXPECT_EQ(fault.get_future().get(), RobotFault::kLink);
  loop.Shutdown();
  for (size_t i = 1; i < robot.targets.size(); ++i) {
    EXPECT_NE(robot.targets[i], DriveTarget(DriveCode::kForward, 4));
  }
}

}  // namespace
}  // namespace rovio_sfm
