#include "rovio_sfm/util/stage_times.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(StageTimes, SumsWhatTheInjectedClockSays) {
  int64_t now_ns = 0;
  StageTimes times([&] { return now_ns; });
  for (const int64_t duration_ns : {5, 7}) {
    const StageTimes::Scope scope = times.Measure("match");
    now_ns += duration_ns;
  }
  EXPECT_EQ(times.totals().at("match").count, 2);
  EXPECT_EQ(times.totals().at("match").total_ns, 12);
}

TEST(StageTimes, NullClockOrNullTimesMeasureNothing) {
  StageTimes times(nullptr);
  { const StageTimes::Scope scope = times.Measure("match"); }
  { const StageTimes::Scope scope = MeasureStage(nullptr, "match"); }
  EXPECT_TRUE(times.totals().empty());
}

}  // namespace
}  // namespace rovio_sfm
