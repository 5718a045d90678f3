#include "rovio_sfm/finish/grid_files.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace rovio_sfm {
namespace {

// Two rows: the one of least y is free, free, occupied.
OccupancyGridMap SmallGrid() {
  using C = GridCell;
  return {0.05,
          {-1.0, 2.0},
          3,
          2,
          {C::kFree, C::kFree, C::kOccupied, C::kUnknown, C::kFree, C::kUnknown}};
}

// As map_server's page says: p = (255 - grey) / 255, occupied above occupied_thresh, free below
// free_thresh, else unknown; the picture's last row is the one of least y.
GridCell CellOfGrey(int grey) {
  const double p = (255 - grey) / 255.0;
  return p > 0.65 ? GridCell::kOccupied : p < 0.196 ? GridCell::kFree : GridCell::kUnknown;
}

TEST(GridPgm, ReadsBackByMapServersRules) {
  const std::string pgm = GridPgm(SmallGrid());
  const cv::Mat picture =
      cv::imdecode(std::vector<uint8_t>(pgm.begin(), pgm.end()), cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(picture.size(), cv::Size(3, 2));
  const OccupancyGridMap grid = SmallGrid();
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_EQ(CellOfGrey(picture.at<uint8_t>(1 - row, column)), grid.At(column, row));
    }
  }
}

TEST(GridYaml, NamesPictureResolutionAndOrigin) {
  EXPECT_EQ(GridYaml(SmallGrid(), "map.pgm"),
            "image: map.pgm\nresolution: 0.05\norigin: [-1, 2, 0.0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

}  // namespace
}  // namespace rovio_sfm
