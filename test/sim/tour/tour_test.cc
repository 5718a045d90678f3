#include "rovio_sfm/sim/tour/tour.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TourSpec ShippedTour(const std::string& name) {
  return LoadTour(ROVIO_SOURCE_DIR "/config/tours/" + name + ".yaml");
}

TEST(PlanTour, EveryShippedTourHasTheLengthOfTheThesis) {
  const std::map<std::string, size_t> lengths = {
      {"visionlab", 55},   {"turntable", 87},   {"industrialArea", 98}, {"pipeline", 88},
      {"engineRoom0", 75}, {"engineRoom1", 72}, {"turntable2", 189}};
  for (const auto& [name, length] : lengths) {
    EXPECT_EQ(PlanTour(ShippedTour(name), 1).size(), length) << name;
  }
}

TEST(PlanTour, EveryStepIsSmall) {
  for (const char* name : {"visionlab", "turntable", "industrialArea", "pipeline", "engineRoom0"}) {
    const std::vector<PlanarPose> poses = PlanTour(ShippedTour(name), 2);
    for (size_t i = 1; i < poses.size(); ++i) {
      const double step_m =
          std::hypot(poses[i].x_m - poses[i - 1].x_m, poses[i].y_m - poses[i - 1].y_m);
      EXPECT_LT(step_m, 0.13) << name << " " << i;
      EXPECT_LT(std::abs(poses[i].yaw_rad - poses[i - 1].yaw_rad), 0.14) << name << " " << i;
    }
  }
}

TEST(PlanTour, TurntableKeepsItsRadius) {
  TourSpec tour = ShippedTour("turntable");
  tour.step_spread = 0.0;
  for (const PlanarPose& pose : PlanTour(tour, 1)) {
    EXPECT_NEAR(std::hypot(pose.x_m - 2.4, pose.y_m - 4.35), 1.12, 0.01);
  }
}

TEST(PlanTour, FollowsAnArc) {
  TourSpec tour = ParseTour(SmallTourYaml(), "short");
  tour.step_spread = 0.0;
  const std::vector<PlanarPose> poses = PlanTour(tour, 1);
  ASSERT_EQ(poses.size(), 7u);
  EXPECT_NEAR(std::hypot(poses[5].x_m - 0.9, poses[5].y_m - 1.8), 0.3, 1e-9);
}

TEST(PlanTour, DependsOnTheSeed) {
  const TourSpec tour = ParseTour(SmallTourYaml(), "short");
  EXPECT_EQ(PlanTour(tour, 1)[3].x_m, PlanTour(tour, 1)[3].x_m);
  EXPECT_NE(PlanTour(tour, 1)[3].x_m, PlanTour(tour, 2)[3].x_m);
}

TEST(WithLongerSteps, GoesTheSameWayWithFewerPictures) {
  TourSpec tour = ShippedTour("turntable");
  tour.step_spread = 0.0;
  const std::vector<PlanarPose> all = PlanTour(tour, 1),
                                half = PlanTour(WithLongerSteps(tour, 2), 1);
  EXPECT_NEAR(static_cast<double>(half.size()), 0.5 * static_cast<double>(all.size()), 2.0);
  EXPECT_EQ(half.back().x_m, all.back().x_m);
  EXPECT_EQ(PlanTour(WithLongerSteps(tour, 1e6), 1).size(), tour.way_points.size());
}

TEST(ParseTour, ReadsWhoWalks) {
  const TourSpec tour = ParseTour(
      SmallTourYaml() + "movers: [{world: person, from_m: [1, 2], to_m: [3, 4], speed_m_s: 0.5}]\n",
      "f");
  ASSERT_EQ(tour.movers.size(), 1u);
  EXPECT_EQ(tour.movers[0].world, "person");
  EXPECT_EQ(tour.movers[0].to_m, Eigen::Vector2d(3, 4));
  EXPECT_THROW(LoadMovers(ParseTour(SmallTourYaml(), "f"), "."), std::runtime_error);
}

TEST(ParseTour, RefusesOneWayPoint) {
  EXPECT_THROW(ParseTour("{name: a, world: b, way_points: [{x_m: 0, y_m: 0, yaw_deg: 0}]}", "f"),
               std::runtime_error);
}

TEST(ParseTour, RefusesAnArcThatMissesItsEnd) {
  std::string yaml = SmallTourYaml();
  yaml.replace(yaml.find("yaw_deg: 90"), 11, "yaw_deg: 60");
  EXPECT_THROW(ParseTour(yaml, "f"), std::runtime_error);
}

TEST(ParseTour, RefusesUnknownKeys) {
  EXPECT_THROW(ParseTour(SmallTourYaml() + "colour: red\n", "f"), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm::sim
