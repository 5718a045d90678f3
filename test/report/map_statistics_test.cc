#include "rovio_sfm/report/map_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/small_snapshot.h"

namespace rovio_sfm {
namespace {

MapStatistics StatisticsOf(const LandmarkBlock& landmarks) {
  MapSnapshot snapshot;
  snapshot.sessions = {SmallSession(1, 5, landmarks)};
  return ComputeMapStatistics(*FindLargestMap(snapshot));
}

TEST(ComputeMapStatistics, CountsImagesAndLandmarksByViews) {
  const MapStatistics s = StatisticsOf({SmallLandmark(1, 2, 0.001), SmallLandmark(2, 3, 0.001),
                                        SmallLandmark(3, 4, 0.001), SmallLandmark(4, 5, 0.009)});
  EXPECT_EQ(s.registered, 4u);
  EXPECT_EQ(s.registered_keyframes, 2u);
  EXPECT_EQ(s.landmarks, 2u);
  EXPECT_EQ(s.landmarks_two_views, 1u);
  EXPECT_EQ(s.landmarks_over_three_views, 1u);
  EXPECT_EQ(s.projections, 9u);
  EXPECT_NEAR(s.mean_error_px, 0.5, 1e-12);
  EXPECT_NEAR(s.rms_counted_px, 0.5 / std::sqrt(2.0), 1e-12);
}

TEST(ComputeMapStatistics, TakesTheRmsOverAllWithMoreThanThreeViews) {
  const MapStatistics s = StatisticsOf(
      {SmallLandmark(1, 2, 0.5), SmallLandmark(2, 3, 0.5), SmallLandmark(3, 4, 0.009)});
  EXPECT_NEAR(s.rms_n, 9.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(s.rms_px, 4.5 / std::sqrt(2.0), 1e-9);
}

TEST(ComputeMapStatistics, IsZeroWithoutLandmarks) {
  const MapStatistics s = StatisticsOf({});
  EXPECT_EQ(s.projections, 0u);
  EXPECT_EQ(s.rms_n, 0.0);
}

}  // namespace
}  // namespace rovio_sfm
