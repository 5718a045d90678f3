#include "rovio_sfm/finish/measure_points.h"

#include <gtest/gtest.h>

#include "finish/small_model.h"

namespace rovio_sfm {
namespace {

TEST(MeasurePoints, IsZeroForAnExactModel) {
  const MapModel model = SmallRoom(5);
  const PointFigures figures = MeasurePoints(model);
  EXPECT_EQ(figures.num_points, model.points.size());
  EXPECT_EQ(figures.num_projections, 5 * model.points.size());
  EXPECT_NEAR(figures.rms_n, 0.0, 1e-9);
}

// Eq. 5.2: the sum of squares over twice the number of views.
TEST(MeasurePoints, IsTheErrorOfOneAxis) {
  MapModel model = SmallRoom(5);
  for (ModelImage& image : model.images) {
    for (Keypoint& keypoint : image.keypoints) keypoint.x_normalized += Eigen::Vector2d(0.01, 0.01);
  }
  EXPECT_NEAR(MeasurePoints(model).rms_n, 10.0, 1e-9);
  EXPECT_NEAR(MeasurePoints(model).rms_px, 3.0, 1e-9);
}

TEST(MeasurePoints, LeavesOutPointsOfThreeViews) {
  MapModel model = SmallRoom(3);
  for (Keypoint& keypoint : model.images[0].keypoints) keypoint.x_normalized.x() += 0.01;
  EXPECT_EQ(MeasurePoints(model).rms_n, 0.0);
  EXPECT_GT(MeasurePoints(model).num_points, 0u);
}

}  // namespace
}  // namespace rovio_sfm
