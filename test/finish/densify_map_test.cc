#include "rovio_sfm/finish/densify_map.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "finish/seen_wall.h"

namespace rovio_sfm {
namespace {

class DensifyMapTest : public testing::Test {
 protected:
  std::optional<DensifiedMap> Densify(const DenseProgress& progress = {}, int num_threads = 0) {
    Executor executor(num_threads);
    return DensifyMap(wall_.model, features_, pictures_, {}, &executor, progress);
  }

  const SeenWall wall_;
  ReadFeatures features_ = [this](const ModelImage& image) { return wall_.stored[image.id.index]; };
  ReadPicture pictures_ = [](const ModelImage& image) {
    return std::make_shared<const std::vector<uint8_t>>(WallPicture(image.id.index));
  };
};

size_t CountOnWall(const PointCloud& cloud) {
  size_t right = 0;
  for (const DensePoint& point : cloud)
    right += std::abs(point.position.z() - kWallDepth) < 0.03 * kWallDepth ? 1 : 0;
  return right;
}

TEST_F(DensifyMapTest, AddsPointsOfTheWallAfterThoseThatWereThere) {
  const auto densified = Densify();
  ASSERT_TRUE(densified);
  const size_t before = wall_.model.points.size();
  EXPECT_EQ(densified->counts.before.num_points, before);
  EXPECT_EQ(densified->counts.after.num_points, densified->cloud.size());
  EXPECT_GT(densified->cloud.size(), 3 * before);
  EXPECT_GT(CountOnWall(densified->cloud), densified->cloud.size() * 98 / 100);
  for (size_t i = 0; i < before; ++i) {
    const Eigen::Vector3f x = wall_.model.points[i].x_in_map.cast<float>();
    EXPECT_LT((densified->cloud[i].position - x).norm(), 0.1f);
  }
}

TEST_F(DensifyMapTest, UsesStoredFeaturesWhereNoPictureIsKept) {
  pictures_ = nullptr;
  const auto densified = Densify();
  ASSERT_TRUE(densified);
  EXPECT_EQ(densified->counts.num_features, 5 * wall_.stored[0]->keypoints.size());
  EXPECT_GE(densified->cloud.size(), wall_.model.points.size());
}

TEST_F(DensifyMapTest, DoesNotDependOnThreads) {
  const auto a = Densify(), b = Densify({}, 2);
  ASSERT_EQ(a->cloud.size(), b->cloud.size());
  for (size_t i = 0; i < a->cloud.size(); ++i) {
    EXPECT_EQ(a->cloud[i].position, b->cloud[i].position);
    EXPECT_EQ(a->cloud[i].num_views, b->cloud[i].num_views);
  }
}

TEST_F(DensifyMapTest, EndsWhenItIsTold) {
  size_t num_told = 0;
  const auto stop = [&](size_t done, size_t all) {
    EXPECT_EQ(done, ++num_told);
    EXPECT_EQ(all, 10u);
    return done < 7;
  };
  EXPECT_FALSE(Densify(stop));
  EXPECT_EQ(num_told, 7u);
}

TEST_F(DensifyMapTest, SaysThatNoDescriptorsAreKept) {
  features_ = [](const ModelImage&) { return nullptr; };
  try {
    Densify();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no descriptors of the map's 5"), std::string::npos);
  }
}

TEST_F(DensifyMapTest, PassesOverAnImageWithoutDescriptors) {
  features_ = [this](const ModelImage& image) {
    return image.id.index == 0 ? nullptr : wall_.stored[image.id.index];
  };
  const auto densified = Densify();
  ASSERT_TRUE(densified);
  EXPECT_GT(densified->cloud.size(), wall_.model.points.size());
}

TEST(RowsOf, SayBeforeAndAfter) {
  DensifyCounts counts;
  counts.before = {10, 30, 0.5, 0.2};
  counts.after = {25, 90, 0.75, 0.3};
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"densified points", "10 → 25"},
      {"densified projections", "30 → 90"},
      {"densified RMS_N", "0.50 → 0.75"}};
  EXPECT_EQ(RowsOf(counts), expected);
}

TEST(Describe, SaysWhatDensifyingBrought) {
  DensifyCounts counts;
  counts.before = {10, 30, 0.5, 0.2};
  counts.after = {25, 90, 0.75, 0.3};
  EXPECT_EQ(Describe(counts),
            "densified: 10 -> 25 points, 30 -> 90 projections, RMS_N 0.50 -> 0.75");
}

}  // namespace
}  // namespace rovio_sfm
