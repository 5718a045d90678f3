#include "rovio_sfm/finish/make_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "finish/small_model.h"

namespace rovio_sfm {
namespace {

GridCell CellAt(const OccupancyGridMap& grid, double x, double y) {
  return grid.At(static_cast<int>(std::floor((x - grid.origin_m.x()) / grid.resolution_m)),
                 static_cast<int>(std::floor((y - grid.origin_m.y()) / grid.resolution_m)));
}

TEST(MakeGrid, AWallIsOccupiedAndTheFloorBeforeItFree) {
  const OccupancyGridMap grid = MakeGrid(SmallRoom(), nullptr, {});
  int occupied = 0, free = 0, wrong = 0;
  for (double y = -0.9; y <= 0.9; y += 0.05) {
    occupied += CellAt(grid, 4.0, y) == GridCell::kOccupied ? 1 : 0;
  }
  for (double x = 0.5; x < 3.8; x += 0.05) {
    free += CellAt(grid, x, 0.0) == GridCell::kFree ? 1 : 0;
    wrong += CellAt(grid, x, 0.0) == GridCell::kOccupied ? 1 : 0;
  }
  EXPECT_GE(occupied, 30);  // of 37
  EXPECT_GE(free, 60);      // of 66
  EXPECT_EQ(wrong, 0);
}

TEST(MakeGrid, BehindTheWallNothingIsKnown) {
  const OccupancyGridMap grid = MakeGrid(SmallRoom(), nullptr, {});
  for (double y = -0.9; y <= 0.9; y += 0.1) {
    EXPECT_EQ(CellAt(grid, 4.3, y), GridCell::kUnknown) << y;
  }
}

TEST(MakeGrid, FreeWhereTheRobotStood) {
  const OccupancyGridMap grid = MakeGrid(SmallRoom(), nullptr, {});
  EXPECT_EQ(CellAt(grid, 0.0, 0.0), GridCell::kFree);
  EXPECT_EQ(CellAt(grid, 0.0, 0.1), GridCell::kFree);
}

TEST(MakeGrid, PointsAboveTheRobotDoNotStandInItsWay) {
  MapModel model = SmallRoom();
  for (ModelPoint& point : model.points) {
    if (point.x_in_map.x() > 3.95) point.x_in_map.z() = 1.0;
  }
  const OccupancyGridMap grid = MakeGrid(model, nullptr, {});
  for (const GridCell cell : grid.cells) EXPECT_NE(cell, GridCell::kOccupied);
}

TEST(MakeGrid, HeightsAreOverTheFloorThatTheMapShows) {
  MapModel model = SmallRoom();
  for (ModelPoint& point : model.points) {
    point.x_in_map.z() += 0.015 + 0.012 * point.x_in_map.x();  // 0.7 deg, 6 cm at the wall
  }
  const OccupancyGridMap grid = MakeGrid(model, nullptr, {});
  for (double x = 1.0; x < 3.8; x += 0.05) {
    for (double y = -0.5; y <= 0.5; y += 0.05) {
      EXPECT_NE(CellAt(grid, x, y), GridCell::kOccupied) << x << " " << y;
    }
  }
  EXPECT_EQ(CellAt(grid, 4.0, 0.01), GridCell::kOccupied);
}

TEST(MakeGrid, ADenseCloudOccupiesToo) {
  PointCloud dense;
  for (int i = 0; i < 3; ++i) dense.push_back({{2.02f, -0.78f, 0.2f}, {}, {}, 3});
  EXPECT_EQ(CellAt(MakeGrid(SmallRoom(), &dense, {}), 2.02, -0.78), GridCell::kOccupied);
}

TEST(MakeGrid, ReachesAsFarAsADenseCloudDoes) {
  PointCloud dense;
  for (int i = 0; i < 3; ++i) dense.push_back({{9.02f, 5.02f, 0.2f}, {}, {}, 3});
  for (int i = 0; i < 3; ++i) dense.push_back({{0.02f, 50.0f, 0.2f}, {}, {}, 3});  // astray
  const OccupancyGridMap grid = MakeGrid(SmallRoom(), &dense, {});
  EXPECT_EQ(CellAt(grid, 9.02, 5.02), GridCell::kOccupied);
  EXPECT_LT(grid.origin_m.y() + grid.height * grid.resolution_m, 6.0);
}

TEST(MakeGrid, RefusesMapUnitsAndIsEmptyWithoutImages) {
  MapModel model = SmallRoom();
  model.length_unit = "map units";
  EXPECT_THROW(MakeGrid(model, nullptr, {}), std::invalid_argument);
  MapModel none;
  none.length_unit = "metres";
  EXPECT_TRUE(MakeGrid(none, nullptr, {}).cells.empty());
}

}  // namespace
}  // namespace rovio_sfm
