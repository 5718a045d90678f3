#include "rovio_sfm/mapping/delayed_result.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace rovio_sfm {
namespace {

TEST(DelayedResult, InReplayItIsDueAfterItsKeyframesWhetherReadyOrNot) {
  std::promise<int> promise;
  DelayedResult<int> result(promise.get_future(), 80, ResultTiming::kFixed);
  for (int i = 0; i < ResultDelay(80); ++i) {
    EXPECT_FALSE(result.IsDue());
    result.CountKeyframe();
  }
  EXPECT_TRUE(result.IsDue());
  EXPECT_FALSE(result.IsReady());
  promise.set_value(7);
  EXPECT_EQ(result.Take(nullptr), 7);
}

TEST(DelayedResult, LiveItIsDueOnceItIsReadyHoweverManyKeyframesCame) {
  std::promise<int> promise;
  DelayedResult<int> result(promise.get_future(), 80, ResultTiming::kWhenReady);
  for (int i = 0; i < 1000; ++i) result.CountKeyframe();
  EXPECT_FALSE(result.IsDue());
  promise.set_value(7);
  EXPECT_TRUE(result.IsDue());
}

TEST(DelayedResult, IsGivenUpOnceNobodyHoldsIt) {
  const auto start = [](Wait wait) {
    return DelayedResult<int>(std::promise<int>().get_future(), 0, ResultTiming::kFixed,
                              std::move(wait));
  };
  std::optional<Wait> wait(std::in_place);
  const std::function<bool()> is_given_up = wait->IsGivenUp();
  auto result = std::make_unique<DelayedResult<int>>(start(*wait));
  wait.reset();
  EXPECT_FALSE(is_given_up());
  auto moved = std::make_unique<DelayedResult<int>>(std::move(*result));
  result.reset();
  EXPECT_FALSE(is_given_up());
  moved.reset();
  EXPECT_TRUE(is_given_up());
}

TEST(DelayedResult, LargerProblemsHaveMoreTime) {
  EXPECT_EQ(ResultDelay(0), 2);
  EXPECT_EQ(ResultDelay(400), 12);
}

TEST(DelayedResult, CountsTheTimesThatItIsWaitedFor) {
  int64_t now_ns = 0;
  StageTimes times([&] { return now_ns += 5; });
  for (const bool ready : {true, false}) {
    std::promise<int> promise;
    if (ready) promise.set_value(7);
    DelayedResult<int> result(
        ready ? promise.get_future() : std::async(std::launch::deferred, [] { return 7; }), 0,
        ResultTiming::kFixed);
    EXPECT_EQ(result.Take(&times), 7);
    EXPECT_EQ(times.totals()["wait"].count, ready ? 0 : 1);
  }
}

}  // namespace
}  // namespace rovio_sfm
