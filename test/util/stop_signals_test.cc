#include "rovio_sfm/util/stop_signals.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

namespace rovio_sfm {
namespace {

// Longer than the time in which a repeated signal is the same wish.
void Wait() {
  const timespec time{0, 600000000};
  ::nanosleep(&time, nullptr);
}

TEST(StopSignals, AsksAtTheFirstAndOnceForRepeatedOnes) {
  const auto ends_by_itself = [] {
    CatchStopSignals();
    if (IsStopRequested() || SecondsSinceStop()) ::_exit(1);
    ::raise(SIGTERM);
    ::raise(SIGTERM);
    ::raise(SIGINT);
    ::_exit(IsStopRequested() && SecondsSinceStop() && StatusOfStop() == 128 + SIGTERM ? 7 : 1);
  };
  EXPECT_EXIT(ends_by_itself(), testing::ExitedWithCode(7), "");
}

TEST(StopSignals, AClosedTerminalAsksButNotUnderNohup) {
  const auto ends_by_itself = [] {
    std::signal(SIGHUP, SIG_IGN);
    CatchStopSignals();
    ::raise(SIGHUP);
    if (IsStopRequested()) ::_exit(1);
    std::signal(SIGHUP, SIG_DFL);
    CatchStopSignals();
    ::raise(SIGHUP);
    ::_exit(IsStopRequested() && StatusOfStop() == 128 + SIGHUP ? 7 : 1);
  };
  EXPECT_EXIT(ends_by_itself(), testing::ExitedWithCode(7), "");
}

TEST(StopSignals, AFileThatMayNotGrowEndsNothing) {
  const auto ends_by_itself = [] {
    CatchStopSignals();
    ::raise(SIGXFSZ);
    ::_exit(IsStopRequested() ? 1 : 7);
  };
  EXPECT_EXIT(ends_by_itself(), testing::ExitedWithCode(7), "");
}

TEST(StopSignals, EndsAtOnceAtTheSecond) {
  const auto is_ended = [] {
    CatchStopSignals();
    ::raise(SIGINT);
    Wait();
    ::raise(SIGTERM);
    ::_exit(1);
  };
  EXPECT_EXIT(is_ended(), testing::ExitedWithCode(128 + SIGTERM), "");
}

TEST(StopSignals, SavesWhatIsBeingSavedBeforeTheSecondEnds) {
  const auto is_ended = [] {
    CatchStopSignals();
    ::raise(SIGINT);
    {
      const HoldSecondStop hold;
      Wait();
      ::raise(SIGINT);
      if (::write(STDERR_FILENO, "saved", 5) != 5) ::_exit(1);
    }
    ::_exit(1);
  };
  EXPECT_EXIT(is_ended(), testing::ExitedWithCode(128 + SIGINT), "saved");
}

TEST(StopSignals, EndsAtTheThirdWhateverIsHeld) {
  const auto is_ended = [] {
    CatchStopSignals();
    const HoldSecondStop hold;
    ::raise(SIGINT);
    Wait();
    ::raise(SIGINT);
    ::raise(SIGINT);
    ::_exit(1);
  };
  EXPECT_EXIT(is_ended(), testing::ExitedWithCode(128 + SIGINT), "");
}

}  // namespace
}  // namespace rovio_sfm
