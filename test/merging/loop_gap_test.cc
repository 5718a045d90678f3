#include "rovio_sfm/merging/loop_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

TEST(MeasureGap, IsZeroWhereBothSayTheSame) {
  const Session b = MappedSession(MakeTwoDrives(), true, {});
  const LoopGap gap = MeasureGap(b, 4, OtherGauge(), OtherGauge());
  EXPECT_NEAR(gap.distance, 0.0, 1e-12);
  EXPECT_NEAR(gap.log_scale, 0.0, 1e-12);
  EXPECT_NEAR(gap.rotation_rad, 0.0, 1e-7);
}

TEST(MeasureGap, SeesShiftTurnAndScale) {
  const Session b = MappedSession(MakeTwoDrives(), true, {});
  const Sim3 shift{1.1, Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY())),
                   Eigen::Vector3d::Zero()};
  const LoopGap gap = MeasureGap(b, 4, shift * OtherGauge(), OtherGauge());
  EXPECT_NEAR(gap.log_scale, std::log(1.1), 1e-12);
  EXPECT_NEAR(gap.rotation_rad, 0.1, 1e-9);
  EXPECT_GT(gap.distance, 0.01);
}

TEST(PathLength, AddsTheStepsOfTheRange) {
  const Session b = MappedSession(MakeTwoDrives(), true, {});
  const double whole = PathLength(b, 0, UINT32_MAX);
  EXPECT_NEAR(PathLength(b, 0, 7) + PathLength(b, 7, UINT32_MAX), whole, 1e-12);
  EXPECT_EQ(PathLength(b, 5, 5), 0.0);
  EXPECT_EQ(PathLength(b, 500, 600), 0.0);
}

TEST(MedianDepth, HasAsManyLandmarksBeforeItAsBehind) {
  const Session b = MappedSession(MakeTwoDrives(), true, {});
  const double median = MedianDepth(b, 4);
  const Keyframe& keyframe = b.keyframe(4);
  int num_nearer = 0, num_farther = 0;
  for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
    if (!keyframe.observed[i]) continue;
    const Landmark& landmark = b.landmarks().at(keyframe.tracks[i]);
    const double depth = (keyframe.cam_from_session * landmark.position).z();
    num_nearer += depth < median - 1e-9 ? 1 : 0;
    num_farther += depth > median + 1e-9 ? 1 : 0;
  }
  EXPECT_GT(num_nearer, 10);
  EXPECT_LE(std::abs(num_nearer - num_farther), 1);
}

}  // namespace
}  // namespace rovio_sfm
