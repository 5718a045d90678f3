#include "rovio_sfm/finish/make_dense_cloud.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "finish/wall_model.h"

namespace rovio_sfm {
namespace {

TEST(MakeDenseCloud, LiesOnTheWall) {
  Executor executor(0);
  const PointCloud cloud = MakeDenseCloud(WallModel(), ReadWall, {}, &executor);
  ASSERT_GT(cloud.size(), 2000u);
  size_t right = 0;
  for (const DensePoint& point : cloud)
    right += std::abs(point.position.z() - kWallDepth) < 0.03 ? 1 : 0;
  EXPECT_GT(right, 0.99 * static_cast<double>(cloud.size()));
}

TEST(MakeDenseCloud, DoesNotDependOnThreads) {
  Executor none(0), two(2);
  const PointCloud a = MakeDenseCloud(WallModel(), ReadWall, {}, &none);
  const PointCloud b = MakeDenseCloud(WallModel(), ReadWall, {}, &two);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].position, b[i].position);
    EXPECT_EQ(a[i].color, b[i].color);
  }
}

TEST(MakeDenseCloud, SaysThatNoPictureIsKept) {
  Executor executor(0);
  try {
    MakeDenseCloud(
        WallModel(), [](const ModelImage&) { return nullptr; }, {}, &executor);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no picture"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("keep_images"), std::string::npos);
  }
}

TEST(MakeDenseCloud, EndsWhenItIsTold) {
  Executor executor(0);
  size_t num_told = 0;
  const auto stop = [&](size_t, size_t) { return ++num_told < 2; };
  EXPECT_TRUE(MakeDenseCloud(WallModel(), ReadWall, {}, &executor, stop).empty());
  EXPECT_EQ(num_told, 2u);
}

}  // namespace
}  // namespace rovio_sfm
