#include "rovio_sfm/ros/job_worker.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(RunAndWait, ReturnsWhenTheJobIsDone) {
  JobWorker worker(4, WhenFull::kDropOldest, [](const Job& job) { job(); });
  int value = 0;
  EXPECT_TRUE(RunAndWait([&] { value = 7; }, &worker));
  EXPECT_EQ(value, 7);
}

TEST(RunAndWait, SaysThatAClosedWorkerDidNothing) {
  JobWorker worker(4, WhenFull::kDropOldest, [](const Job& job) { job(); });
  worker.Finish();
  EXPECT_FALSE(RunAndWait([] {}, &worker));
}

}  // namespace
}  // namespace rovio_sfm
