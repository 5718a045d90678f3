#include "rovio_sfm/app/tour_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace rovio_sfm {
namespace {

std::string ErrorOf(const std::string& yaml) {
  try {
    ParseTourWayPoints(yaml, "tour");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(ParseTourWayPoints, ReadsWhatTheDriverNeedsAndLeavesTheRest) {
  const std::vector<TourWayPoint> way_points = ParseTourWayPoints(
      "name: x\nworld: y\nway_points:\n  - {x_m: 1, y_m: 2, yaw_deg: 90}\n"
      "  - {x_m: 3, y_m: 2, yaw_deg: 180, frames: 5, arc_center_m: [2, 2]}\n",
      "tour");
  ASSERT_EQ(way_points.size(), 2u);
  EXPECT_DOUBLE_EQ(way_points[0].pose.yaw_rad, M_PI / 2);
  EXPECT_FALSE(way_points[0].arc_center_m);
  EXPECT_EQ(way_points[1].num_pictures, 5);
  EXPECT_EQ(*way_points[1].arc_center_m, Eigen::Vector2d(2, 2));
}

TEST(ParseTourWayPoints, NamesWhatIsWrong) {
  EXPECT_EQ(ErrorOf("name: x"), "tour: way_points: expected a list of 1 to 10000 way-points");
  EXPECT_EQ(ErrorOf("way_points: [{x_m: no}]"),
            "tour: way_points[0].x_m: expected a number, not 'no'");
  EXPECT_EQ(ErrorOf("way_points: [{z_m: 1}]"), "tour: way_points[0].z_m: unknown key");
  EXPECT_EQ(ErrorOf("way_points: [{frames: 0}]"),
            "tour: way_points[0].frames: expected 1 to 10000");
  EXPECT_EQ(ErrorOf("way_points: [{arc_center_m: [1]}]"),
            "tour: way_points[0].arc_center_m: expected two numbers");
  EXPECT_NE(ErrorOf("way_points: [{x_m: .nan}]"), "none");
  EXPECT_NE(ErrorOf("way_points: ["), "none");
}

TEST(LoadTourWayPoints, LoadsAShippedTour) {
  const std::vector<TourWayPoint> way_points =
      LoadTourWayPoints(std::string(ROVIO_SOURCE_DIR) + "/config/tours/visionlab.yaml");
  EXPECT_EQ(PlanStops(way_points).size(), 55u);
  EXPECT_THROW(LoadTourWayPoints("/nowhere/tour.yaml"), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
