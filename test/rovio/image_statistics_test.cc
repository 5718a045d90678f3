#include "rovio_sfm/rovio/image_statistics.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

constexpr int64_t kMillisecond = 1000000;

TEST(ImageStatistics, TellsRateJitterAndTransfer) {
  ImageStatistics statistics;
  for (const int64_t stamp_ms : {0, 100, 150, 250}) {
    statistics.Add(stamp_ms * kMillisecond, (stamp_ms + 20) * kMillisecond);
  }
  const ImageFigures figures = statistics.Take();
  EXPECT_EQ(figures.count, 4u);
  EXPECT_NEAR(figures.mean_interval_s, 0.25 / 3, 1e-9);
  EXPECT_NEAR(figures.jitter_s, 0.0235702, 1e-6);
  EXPECT_NEAR(figures.mean_transfer_s, 0.02, 1e-9);
  EXPECT_NEAR(figures.max_transfer_s, 0.02, 1e-9);
}

TEST(ImageStatistics, BeginsAnewButKeepsTheIntervalAcrossPeriods) {
  ImageStatistics statistics;
  statistics.Add(0, 0);
  statistics.Take();
  statistics.Add(200 * kMillisecond, 200 * kMillisecond);
  EXPECT_NEAR(statistics.Take().mean_interval_s, 0.2, 1e-9);
  EXPECT_EQ(statistics.Take().count, 0u);
}

}  // namespace
}  // namespace rovio_sfm
