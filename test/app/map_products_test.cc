#include "rovio_sfm/app/map_products.h"

#include <gtest/gtest.h>

#include "app/small_picture.h"

namespace rovio_sfm {
namespace {

constexpr MapId kMap = {1};

MapPicture WithScale(const MapPicture& picture, double metres_per_unit) {
  return After(picture, [&](MapSnapshot* snapshot) {
    snapshot->sessions[0].scale = MapScale{metres_per_unit, 0.01, "odometry"};
  });
}

MapProducts OnePoint() {
  MapProducts made;
  made.dense = std::make_shared<const PointCloud>(
      PointCloud{{{1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 1.0f}, {10, 20, 30}, 2}});
  return made;
}

// What is kept of the map; null pointers where nothing is.
MapProducts Kept(const MapPicture& now, ProductShelf* shelf) { return shelf->Fitting(now)[kMap]; }

TEST(GaugeOf, IsNothingForAMapThatIsNotThere) {
  EXPECT_FALSE(GaugeOf(Picture(1), {7}));
  EXPECT_TRUE(GaugeOf(Picture(1), kMap));
}

TEST(GaugeOf, StaysWhileTheMapGrowsAndGetsItsScale) {
  const MapPicture picture = Picture(2);
  const MapPicture grown =
      After(picture, [](MapSnapshot* snapshot) { ++snapshot->sessions[0].revision; });
  EXPECT_TRUE(*GaugeOf(picture, kMap) == *GaugeOf(grown, kMap));
  EXPECT_TRUE(*GaugeOf(picture, kMap) == *GaugeOf(WithScale(picture, 2.0), kMap));
}

TEST(ProductShelf, KeepsWhatWasMadeWhileTheMapGrows) {
  const MapPicture picture = Picture(1);
  ProductShelf shelf;
  const MapProducts made = OnePoint();
  ASSERT_TRUE(shelf.Put(*GaugeOf(picture, kMap), picture, made));
  const MapPicture grown =
      After(picture, [](MapSnapshot* snapshot) { ++snapshot->sessions[0].revision; });
  EXPECT_EQ(Kept(grown, &shelf).dense, made.dense);  // the very same: nothing is sent again
}

TEST(ProductShelf, AddsToWhatWasMadeBefore) {
  const MapPicture picture = Picture(1);
  ProductShelf shelf;
  ASSERT_TRUE(shelf.Put(*GaugeOf(picture, kMap), picture, OnePoint()));
  MapProducts surface;
  surface.surface = std::make_shared<const TriangleMesh>();
  ASSERT_TRUE(shelf.Put(*GaugeOf(picture, kMap), picture, surface));
  EXPECT_TRUE(Kept(picture, &shelf).dense && Kept(picture, &shelf).surface);
}

TEST(ProductShelf, KnowsWhichCloudIsTheNewest) {
  const MapPicture picture = Picture(1);
  const MapGauge gauge = *GaugeOf(picture, kMap);
  ProductShelf shelf;
  const MapProducts by_depth = OnePoint();
  MapProducts by_matches;
  by_matches.densified = by_depth.dense;
  ASSERT_TRUE(shelf.Put(gauge, picture, by_depth) && shelf.Put(gauge, picture, by_matches));
  EXPECT_TRUE(Kept(picture, &shelf).is_densified_newer);
  EXPECT_TRUE(Kept(picture, &shelf).dense && Kept(WithScale(picture, 2.0), &shelf).densified);
  ASSERT_TRUE(shelf.Put(gauge, picture, by_depth));
  EXPECT_EQ(Kept(picture, &shelf).NewestCloud(), by_depth.dense);
}

TEST(ProductShelf, ForgetsWhatWasMadeOfAMapThatIsAnotherNow) {
  const MapPicture picture = Picture(2);
  const MapPicture merged = After(picture, [](MapSnapshot* snapshot) {
    snapshot->sessions[1].map = kMap;
    for (SessionSnapshot& session : snapshot->sessions) session.gauge_revision = 1;
  });
  MapPicture reset = picture;
  ++reset.epoch;
  for (const MapPicture& now : {merged, reset}) {
    ProductShelf shelf;
    const MapGauge then = *GaugeOf(picture, kMap);
    ASSERT_TRUE(shelf.Put(then, picture, OnePoint()));
    EXPECT_FALSE(Kept(now, &shelf).dense);
    EXPECT_FALSE(shelf.Put(then, now, OnePoint()));
    EXPECT_FALSE(Kept(now, &shelf).dense);
  }
}

TEST(ProductShelf, MovesPointsAndCornersWithANewScale) {
  const MapPicture picture = Picture(1);
  ProductShelf shelf;
  MapProducts made = OnePoint();
  made.surface = std::make_shared<const TriangleMesh>(TriangleMesh{*made.dense, {}});
  made.grid = std::make_shared<const OccupancyGridMap>();
  ASSERT_TRUE(shelf.Put(*GaugeOf(picture, kMap), picture, made));
  const MapProducts moved = Kept(WithScale(picture, 2.0), &shelf);
  ASSERT_TRUE(moved.dense && moved.surface);
  EXPECT_TRUE((*moved.dense)[0].position.isApprox(Eigen::Vector3f(2.0f, 4.0f, 6.0f), 1e-6f));
  EXPECT_TRUE((*moved.dense)[0].normal.isApprox(Eigen::Vector3f::UnitZ(), 1e-6f));
  EXPECT_TRUE(moved.surface->vertices[0].position.isApprox((*moved.dense)[0].position));
  EXPECT_FALSE(moved.grid);
}

TEST(ProductShelf, MovesWhatWasMadeBeforeTheNewestScale) {
  const MapPicture picture = Picture(1);
  ProductShelf shelf;
  const MapPicture now = WithScale(picture, 3.0);
  ASSERT_TRUE(shelf.Put(*GaugeOf(picture, kMap), now, OnePoint()));
  const PointCloud moved = *Kept(now, &shelf).dense;
  EXPECT_TRUE(moved[0].position.isApprox(Eigen::Vector3f(3.0f, 6.0f, 9.0f), 1e-6f));
}

}  // namespace
}  // namespace rovio_sfm
