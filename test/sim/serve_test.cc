#include "rovio_sfm/sim/serve.h"

#include <gtest/gtest.h>
#include <signal.h>

#include "sim/http/fake_robot.h"

namespace rovio_sfm::sim {
namespace {

TEST(RealTimeClock, RunsForwardFromTheUnixEpoch) {
  const Clock now_ns = RealTimeClock();
  const int64_t first = now_ns();
  EXPECT_GT(first, 1'600'000'000'000'000'000);
  EXPECT_GE(now_ns(), first);
}

// The signal waits, blocked, until ServeRobot takes it.
TEST(ServeRobot, EndsWellOnATerminationSignal) {
  sigset_t signals, before;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, &before);
  pthread_kill(pthread_self(), SIGTERM);
  FakeRobot robot;
  EXPECT_EQ(ServeRobot({}, robot), 0);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

TEST(ServeRobot, RefusesWrongQuirksAndFolders) {
  FakeRobot robot;
  ServeOptions options;
  options.quirks = {"stall"};
  EXPECT_EQ(ServeRobot(options, robot), 1);
  options.quirks = {"nonsense=1"};
  EXPECT_EQ(ServeRobot(options, robot), 1);
  EXPECT_EQ(ServeImages({}, "/nowhere", false), 1);
}

}  // namespace
}  // namespace rovio_sfm::sim
