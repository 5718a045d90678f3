#include "rovio_sfm/surface/reconstruct_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

// The upper half of a unit sphere, its points off by `noise`, red on one side and blue on the
// other.
PointCloud HalfSphere(size_t count, double noise) {
  Rng rng(5);
  PointCloud cloud;
  while (cloud.size() < count) {
    Eigen::Vector3d x(rng.Gaussian(), rng.Gaussian(), rng.Gaussian());
    x.normalize();
    if (x.z() < 0.0) continue;
    DensePoint point;
    point.position = ((1.0 + noise * rng.Gaussian()) * x).cast<float>();
    point.normal = x.cast<float>();
    point.color = x.x() > 0.0 ? Rgb{200, 0, 0} : Rgb{0, 0, 200};
    cloud.push_back(point);
  }
  return cloud;
}

SurfaceOptions Coarse() {
  SurfaceOptions options;
  options.poisson_depth = 6;
  return options;
}

TEST(ReconstructSurface, LiesOnTheSphere) {
  const TriangleMesh mesh = ReconstructSurface(HalfSphere(6000, 0.003), Coarse());
  ASSERT_GT(mesh.triangles.size(), 1000u);
  double worst = 0.0, sum = 0.0;
  for (const DensePoint& corner : mesh.vertices) {
    const double gap = std::abs(corner.position.norm() - 1.0);
    worst = std::max(worst, gap);
    sum += gap;
  }
  EXPECT_LT(sum / static_cast<double>(mesh.vertices.size()), 0.01);
  EXPECT_LT(worst, 0.1);
}

TEST(ReconstructSurface, LeavesOpenWhatNobodySaw) {
  const TriangleMesh mesh = ReconstructSurface(HalfSphere(6000, 0.003), Coarse());
  for (const DensePoint& corner : mesh.vertices) EXPECT_GT(corner.position.z(), -0.15f);
}

TEST(ReconstructSurface, HasTheColorsOfThePoints) {
  const TriangleMesh mesh = ReconstructSurface(HalfSphere(6000, 0.003), Coarse());
  for (const DensePoint& corner : mesh.vertices) {
    if (std::abs(corner.position.x()) < 0.2f) continue;
    EXPECT_EQ(corner.color[0] > 0, corner.position.x() > 0.0f);
  }
}

TEST(ReconstructSurface, DropsPointsThatFloatAlone) {
  PointCloud cloud = HalfSphere(6000, 0.003);
  for (const float x : {3.0f, -4.0f, 5.0f}) {
    cloud.push_back({{x, x, x}, {0.0f, 0.0f, 1.0f}, {}, 2});
  }
  for (const DensePoint& corner : ReconstructSurface(cloud, Coarse()).vertices) {
    EXPECT_LT(corner.position.norm(), 1.3f);
  }
}

TEST(ReconstructSurface, TellsItsStepsAndEndsWhereItIsTold) {
  std::vector<size_t> told;
  const auto until = [&](size_t last) {
    told.clear();
    return [&told, last](size_t num_done, size_t) {
      told.push_back(num_done);
      return num_done < last;
    };
  };
  EXPECT_FALSE(ReconstructSurface(HalfSphere(6000, 0.003), Coarse(), until(9)).triangles.empty());
  EXPECT_EQ(told, (std::vector<size_t>{1, 2, 3, kSurfaceSteps}));
  EXPECT_TRUE(ReconstructSurface(HalfSphere(6000, 0.003), Coarse(), until(2)).triangles.empty());
  EXPECT_EQ(told, (std::vector<size_t>{1, 2}));
}

TEST(ReconstructSurface, NothingOfAFewPoints) {
  EXPECT_TRUE(ReconstructSurface(HalfSphere(50, 0.0), {}).triangles.empty());
  EXPECT_TRUE(ReconstructSurface({}, {}).vertices.empty());
}

}  // namespace
}  // namespace rovio_sfm
