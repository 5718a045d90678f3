#include "rovio_sfm/sim/http/stop_signal.h"

#include <gtest/gtest.h>

#include <thread>

namespace rovio_sfm::sim {
namespace {

TEST(StopSignal, WaitEndsAfterItsTimeWithoutARequest) {
  StopSignal signal;
  EXPECT_FALSE(signal.WaitFor(std::chrono::nanoseconds(1)));
  EXPECT_FALSE(signal.IsRequested());
}

TEST(StopSignal, RequestEndsALongWaitOfAnotherThread) {
  StopSignal signal;
  bool stopped = false;
  std::thread waiting([&] { stopped = signal.WaitFor(std::chrono::hours(1)); });
  signal.Request();
  waiting.join();
  EXPECT_TRUE(stopped);
  EXPECT_TRUE(signal.IsRequested());
}

}  // namespace
}  // namespace rovio_sfm::sim
