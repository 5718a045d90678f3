#include <gtest/gtest.h>

#include "merging/merged_pair.h"
#include "rovio_sfm/merging/adjust_map.h"

namespace rovio_sfm {
namespace {

TEST(MapCameras, FindsTheCameraOfOneDriveAndLeavesTheOthers) {
  MergedPair pair(0.1);
  const Camera truth = pair.a.camera();
  const Eigen::Vector3d error(0.004, 0.003, -0.003);
  ASSERT_TRUE(pair.a.SetCamera(CorrectedCamera(truth, error)));
  AdjustMapFinally(pair.placed, {}, &pair.links);
  EXPECT_LT(CorrectionOf(truth, pair.a.camera()).norm(), 0.3 * error.norm());
  EXPECT_LT(CorrectionOf(truth, pair.b.camera()).norm(), 0.3 * error.norm());
  EXPECT_EQ(CheckInvariants(pair.a) + CheckInvariants(pair.b), "");
}

TEST(MapCameras, KeepsCamerasThatAreSaidToBeExact) {
  MergedPair pair(0.1);
  const Camera wrong = CorrectedCamera(pair.a.camera(), {0.004, 0.003, -0.003});
  ASSERT_TRUE(pair.a.SetCamera(wrong));
  MapperOptions exact;
  exact.adjust.focal_sigma = 0.0;
  AdjustMapFinally(pair.placed, exact, &pair.links);
  EXPECT_TRUE(pair.a.camera() == wrong);
}

}  // namespace
}  // namespace rovio_sfm
