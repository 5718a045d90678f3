#include "rovio_sfm/sfm/estimate_floor_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr double kMetresPerUnit = 0.4;
constexpr double kHeightM = 0.25;

struct RoomOptions {
  uint64_t seed = 1;
  double noise_m = 0.0;        // of points and cameras
  double up_error_rad = 0.0;   // of all up directions alike
  double rock_rad = 0.0;       // of each camera
  double height_step_m = 0.0;  // of every other camera
  int num_floor = 400;
  double floor_width_m = 3.0;
  int num_table = 0;  // points 0.1 m above the floor
  int num_below = 0;  // mirrored in the floor
};

struct Room {
  std::vector<FloorCamera> cameras;
  std::vector<Eigen::Vector3d> points;
};

// A curved drive of 3 m amid walls and a floor, in metres, z up from the floor.
Room MakeRoomInMetres(const RoomOptions& options) {
  Rng rng(options.seed);
  const auto noise = [&] { return options.noise_m * rng.Gaussian(); };
  const auto point = [&](double width_m, double low_m, double high_m) {
    return Eigen::Vector3d(rng.Uniform(0.0, 4.0) + noise(),
                           rng.Uniform(-0.5, 0.5) * width_m + noise(),
                           rng.Uniform(low_m, high_m) + noise());
  };
  Room room;
  for (int i = 0; i < 30; ++i) {
    FloorCamera camera;
    camera.height_m = kHeightM + (i % 2) * options.height_step_m;
    camera.center_in_map = {0.1 * i, 0.3 * std::sin(0.2 * i), camera.height_m + noise()};
    const Eigen::AngleAxisd rocked(options.rock_rad * rng.Gaussian(), Eigen::Vector3d::UnitX());
    const Eigen::AngleAxisd wrong(options.up_error_rad, Eigen::Vector3d::UnitY());
    camera.up_in_map = wrong * rocked * Eigen::Vector3d::UnitZ();
    room.cameras.push_back(camera);
  }
  for (int i = 0; i < options.num_floor; ++i) {
    room.points.push_back(point(options.floor_width_m, 0.0, 0.0));
  }
  for (int i = 0; i < options.num_table; ++i) room.points.push_back(point(3.0, 0.1, 0.1));
  for (int i = 0; i < options.num_below; ++i) room.points.push_back(point(3.0, -2.0, -0.2));
  for (int i = 0; i < 500; ++i) room.points.push_back(point(3.0, 0.0, 2.5));
  return room;
}

// The same in map units and any gauge.
Room MakeRoom(const RoomOptions& options) {
  Room room = MakeRoomInMetres(options);
  const Sim3 map_from_room{
      1.0 / kMetresPerUnit,
      Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, -2).normalized())),
      Eigen::Vector3d(3.0, -1.0, 2.0)};
  for (FloorCamera& camera : room.cameras) {
    camera.center_in_map = map_from_room * camera.center_in_map;
    camera.up_in_map = map_from_room.rotation * camera.up_in_map;
  }
  for (Eigen::Vector3d& point : room.points) point = map_from_room * point;
  return room;
}

std::optional<MapScale> ScaleOf(const RoomOptions& options) {
  const Room room = MakeRoom(options);
  return EstimateFloorScale(room.cameras, room.points, {});
}

TEST(EstimateFloorScale, IsExactOnAFlatFloorWithoutNoise) {
  RoomOptions options;
  const auto scale = ScaleOf(options);
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->metres_per_unit, kMetresPerUnit, 0.01 * kMetresPerUnit);
  EXPECT_EQ(scale->source, "camera height");
  EXPECT_GE(scale->sigma_log, FloorUncertainty{}.height_sigma);
}

TEST(EstimateFloorScale, LearnsTheFloorsDirectionFromCamerasAndPoints) {
  RoomOptions options;
  options.up_error_rad = 0.02;
  options.noise_m = 0.003;
  const auto scale = ScaleOf(options);
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->metres_per_unit, kMetresPerUnit, 0.03 * kMetresPerUnit);
}

TEST(EstimateFloorScale, TakesCamerasOfSeveralHeights) {
  RoomOptions options;
  options.height_step_m = 0.1;
  const auto scale = ScaleOf(options);
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->metres_per_unit, kMetresPerUnit, 0.01 * kMetresPerUnit);
}

TEST(EstimateFloorScale, LooksThroughATableToTheFloor) {
  RoomOptions options;
  options.num_table = 1500;
  const auto scale = ScaleOf(options);
  ASSERT_TRUE(scale.has_value());
  EXPECT_NEAR(scale->metres_per_unit, kMetresPerUnit, 0.02 * kMetresPerUnit);
}

TEST(EstimateFloorScale, TrueScaleLiesInsideTwoSigma) {
  int num_inside = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    RoomOptions options;
    options.seed = seed;
    options.noise_m = 0.005;
    options.rock_rad = 0.01;
    options.num_floor = 60;
    const auto scale = ScaleOf(options);
    ASSERT_TRUE(scale.has_value()) << seed;
    const double error = std::abs(std::log(scale->metres_per_unit / kMetresPerUnit));
    num_inside += error <= 2.0 * scale->sigma_log;
  }
  EXPECT_GE(num_inside, 19);
}

TEST(EstimateFloorScale, RefusesWithoutAFloor) {
  RoomOptions options;
  options.num_floor = 0;
  EXPECT_FALSE(ScaleOf(options).has_value());
}

TEST(EstimateFloorScale, RefusesAFloorWithMuchBelowIt) {
  RoomOptions options;
  options.num_below = 200;
  EXPECT_FALSE(ScaleOf(options).has_value());
}

TEST(EstimateFloorScale, RefusesAStripe) {
  RoomOptions options;
  options.floor_width_m = 0.01;
  EXPECT_FALSE(ScaleOf(options).has_value());
}

TEST(EstimateFloorScale, RefusesCamerasInNoPlane) {
  Room room = MakeRoom({});
  for (size_t i = 0; i < room.cameras.size(); ++i) {
    room.cameras[i].center_in_map +=
        0.2 * std::sin(2.0 * static_cast<double>(i)) * room.cameras[i].up_in_map / kMetresPerUnit;
  }
  EXPECT_FALSE(EstimateFloorScale(room.cameras, room.points, {}).has_value());
}

TEST(EstimateFloorScale, RefusesEmptyInput) {
  EXPECT_FALSE(EstimateFloorScale({}, {}, {}).has_value());
  EXPECT_FALSE(EstimateFloorScale(MakeRoom({}).cameras, {}, {}).has_value());
}

}  // namespace
}  // namespace rovio_sfm
