#include "rovio_sfm/geometry/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

// The colour camera of TUM fr1: strong distortion, tangential too.
Camera MakeStrongCamera() {
  Camera camera;
  camera.fx = 517.3;
  camera.fy = 516.5;
  camera.cx = 318.6;
  camera.cy = 255.3;
  camera.k1 = 0.2624;
  camera.k2 = -0.9531;
  camera.p1 = -0.0054;
  camera.p2 = 0.0026;
  camera.k3 = 1.1633;
  camera.width = 640;
  camera.height = 480;
  return camera;
}

TEST(Camera, ProjectsTheAxisToThePrincipalPoint) {
  EXPECT_EQ(PixelFromNormalized(MakeStrongCamera(), {0, 0}), Eigen::Vector2d(318.6, 255.3));
}

TEST(Camera, DistortsAsOpenCvDoes) {
  // Values from the formula of OpenCV's documentation, written out.
  const Camera camera = MakeStrongCamera();
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const double radial = 1 + camera.k1 * r2 + camera.k2 * r2 * r2 + camera.k3 * r2 * r2 * r2;
  const double xd = x * radial + 2 * camera.p1 * x * y + camera.p2 * (r2 + 2 * x * x);
  const double yd = y * radial + camera.p1 * (r2 + 2 * y * y) + 2 * camera.p2 * x * y;
  const Eigen::Vector2d expected(camera.fx * xd + camera.cx, camera.fy * yd + camera.cy);
  EXPECT_LT((PixelFromNormalized(camera, {x, y}) - expected).norm(), 1e-10);
}

TEST(Camera, UndistortsTheWholeImageToAMillionthOfAPixel) {
  for (const Camera& camera : {MakeStrongCamera(), MakeSyntheticCamera()}) {
    for (int v = 0; v < camera.height; v += 13) {
      for (int u = 0; u < camera.width; u += 13) {
        const Eigen::Vector2d x_px(u, v);
        const auto x_normalized = NormalizedFromPixel(camera, x_px);
        ASSERT_TRUE(x_normalized) << u << " " << v;
        EXPECT_LT((PixelFromNormalized(camera, *x_normalized) - x_px).norm(), 1e-6);
      }
    }
  }
}

TEST(Camera, UndistortionTakesProjectionBack) {
  const Camera camera = MakeStrongCamera();
  for (const double x : {-0.5, -0.1, 0.0, 0.3}) {
    const Eigen::Vector2d point(x, 0.35);
    const auto back = NormalizedFromPixel(camera, PixelFromNormalized(camera, point));
    ASSERT_TRUE(back);
    EXPECT_LT((*back - point).norm(), 1e-9);
  }
}

TEST(Camera, RefusesPixelsThatTheDistortionCannotReach) {
  Camera camera = MakeSyntheticCamera();
  camera.k1 = -0.4;  // folds back at radius 0.91
  camera.k2 = 0.0;
  EXPECT_FALSE(NormalizedFromPixel(camera, {camera.cx + 0.9 * camera.fx, camera.cy}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(NormalizedFromPixel(camera, {nan, 0.0}));
}

TEST(Camera, IsValidNamesTheBadField) {
  std::string error;
  EXPECT_TRUE(MakeStrongCamera().IsValid(&error));
  const auto expect_refused = [&](const Camera& camera, const char* field) {
    EXPECT_FALSE(camera.IsValid(&error));
    EXPECT_NE(error.find(field), std::string::npos) << error;
  };
  Camera camera = MakeStrongCamera();
  camera.width = 0;
  expect_refused(camera, "width");
  camera = MakeStrongCamera();
  camera.fy = std::numeric_limits<double>::quiet_NaN();
  expect_refused(camera, "fy");
  camera = MakeStrongCamera();
  camera.k3 = std::numeric_limits<double>::infinity();
  expect_refused(camera, "k3");
  expect_refused(Camera(), "width");
}

TEST(Camera, ACorrectionIsWhatOneCalibrationIsFromAnother) {
  const Camera camera = MakeStrongCamera();
  const Eigen::Vector3d correction(0.01, -0.02, 0.03);
  EXPECT_LT((CorrectionOf(camera, CorrectedCamera(camera, correction)) - correction).norm(), 1e-12);
  EXPECT_TRUE(CorrectedCamera(camera, Eigen::Vector3d::Zero()) == camera);
}

TEST(Camera, APixelMovesWithACorrectionAsFiniteDifferencesDo) {
  const Camera camera = MakeStrongCamera();
  constexpr double kStep = 1e-5;
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(20, 30), {320, 240}, {600, 100}}) {
    const Eigen::Vector2d x = *NormalizedFromPixel(camera, pixel);
    const Eigen::Matrix<double, 2, 3> by_correction = NormalizedByCorrection(camera, x);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
      const Eigen::Vector2d after = *NormalizedFromPixel(CorrectedCamera(camera, step), pixel);
      const Eigen::Vector2d before = *NormalizedFromPixel(CorrectedCamera(camera, -step), pixel);
      EXPECT_LT(((after - before) / (2.0 * kStep) - by_correction.col(i)).norm(), 1e-4);
    }
  }
}

TEST(Camera, ComparesAllFields) {
  Camera camera = MakeStrongCamera();
  EXPECT_TRUE(camera == MakeStrongCamera());
  camera.p2 += 1e-9;
  EXPECT_FALSE(camera == MakeStrongCamera());
  EXPECT_NEAR(camera.MeanFocal(), 516.9, 1e-9);
}

}  // namespace
}  // namespace rovio_sfm
