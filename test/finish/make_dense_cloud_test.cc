#include "rovio_sfm/finish/make_dense_cloud.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

constexpr double kDepth = 2.0;
constexpr std::pair<double, double> kPlaces[] = {
    {0.0, 0.0}, {0.2, 0.0}, {-0.2, 0.0}, {0.0, 0.2}, {0.0, -0.2}};

// The textured wall, seen from five places, and some points on it.
MapModel WallModel() {
  MapModel model;
  model.length_unit = "metres";
  model.cameras.push_back(SmallCamera());
  for (const auto& [x, y] : kPlaces) {
    ModelImage image;
    image.id.index = static_cast<uint32_t>(model.images.size());
    image.cam_from_map.translation = {-x, -y, 0.0};
    model.images.push_back(image);
  }
  for (int i = 0; i < 60; ++i) {
    ModelPoint point;
    point.x_in_map = {0.1 * (i % 10) - 0.45, 0.1 * (i / 10) - 0.3, kDepth};
    for (uint32_t view = 0; view < 5; ++view) point.views.push_back({view, 0});
    model.points.push_back(point);
  }
  return model;
}

std::shared_ptr<const std::vector<uint8_t>> ReadWall(const ModelImage& image) {
  const auto& [x, y] = kPlaces[image.id.index];
  std::vector<uint8_t> png;
  cv::imencode(".png", SeeWall(x, y, kDepth), png);
  return std::make_shared<const std::vector<uint8_t>>(std::move(png));
}

TEST(MakeDenseCloud, LiesOnTheWall) {
  Executor executor(0);
  const PointCloud cloud = MakeDenseCloud(WallModel(), ReadWall, {}, &executor);
  ASSERT_GT(cloud.size(), 2000u);
  size_t right = 0;
  for (const DensePoint& point : cloud)
    right += std::abs(point.position.z() - kDepth) < 0.03 ? 1 : 0;
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
