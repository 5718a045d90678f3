#include "rovio_sfm/sfm/estimate_odometry_delay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

struct TurnOptions {
  uint64_t seed = 1;
  double delay_s = 0.0;
  double step_s = 0.1;
  double turn = 1.0;         // 0: straight on
  double noise_rad = 0.0;    // of both headings
  double gain = 1.0;         // of the wheels
  double drift_rad_s = 0.0;  // of the wheels
};

// The heading of a robot that turns to and fro, never for the same time.
double Heading(const TurnOptions& options, double time_s) {
  return options.turn * (0.6 * std::sin(1.1 * time_s) + 0.4 * std::sin(2.3 * time_s + 1.0));
}

std::vector<TurnSample> MakeTurns(const TurnOptions& options, int count = 200) {
  Rng rng(options.seed);
  const Eigen::Quaterniond map_from_level(
      Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, -2, 2).normalized()));
  std::vector<TurnSample> samples;
  for (int i = 0; i < count; ++i) {
    const double time_s = i * options.step_s;
    const double seen_rad = Heading(options, time_s) + options.noise_rad * rng.Gaussian();
    TurnSample sample;
    sample.stamp_ns = 1600000000000000000 + static_cast<int64_t>(1e9 * time_s);
    sample.map_from_base = map_from_level * Eigen::AngleAxisd(seen_rad, Eigen::Vector3d::UnitZ());
    sample.odom_yaw_rad = options.gain * Heading(options, time_s - options.delay_s) +
                          options.drift_rad_s * time_s + options.noise_rad * rng.Gaussian();
    samples.push_back(sample);
  }
  return samples;
}

std::optional<OdometryDelay> DelayOf(const TurnOptions& options) {
  return EstimateOdometryDelay(MakeTurns(options));
}

TEST(EstimateOdometryDelay, FindsLateAndEarlyOdometry) {
  for (const double delay_s : {-0.13, -0.04, 0.0, 0.025, 0.21}) {
    TurnOptions options;
    options.delay_s = delay_s;
    const auto delay = DelayOf(options);
    ASSERT_TRUE(delay.has_value()) << delay_s;
    EXPECT_NEAR(delay->delay_s, delay_s, 0.006);
  }
}

TEST(EstimateOdometryDelay, WorksBetweenFramesFarApart) {
  TurnOptions options;
  options.delay_s = 0.08;
  options.step_s = 0.3;
  const auto delay = DelayOf(options);
  ASSERT_TRUE(delay.has_value());
  EXPECT_NEAR(delay->delay_s, 0.08, 0.02);
}

TEST(EstimateOdometryDelay, BearsGainAndDriftOfTheWheels) {
  TurnOptions options;
  options.delay_s = 0.06;
  options.gain = 0.8;
  options.drift_rad_s = 0.02;
  const auto delay = DelayOf(options);
  ASSERT_TRUE(delay.has_value());
  EXPECT_NEAR(delay->delay_s, 0.06, 0.01);
}

TEST(EstimateOdometryDelay, TrueDelayLiesInsideTwoSigmaOrTenMilliseconds) {
  int num_inside = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    TurnOptions options;
    options.seed = seed;
    options.delay_s = 0.07;
    options.noise_rad = 0.01;
    const auto delay = DelayOf(options);
    ASSERT_TRUE(delay.has_value()) << seed;
    num_inside += std::abs(delay->delay_s - 0.07) <= std::max(0.01, 2.0 * delay->sigma_s);
  }
  EXPECT_GE(num_inside, 18);
}

TEST(EstimateOdometryDelay, RefusesWithoutTurns) {
  TurnOptions options;
  options.turn = 0.0;
  options.noise_rad = 0.002;
  EXPECT_FALSE(DelayOf(options).has_value());
}

TEST(EstimateOdometryDelay, RefusesASteadyTurn) {
  std::vector<TurnSample> samples = MakeTurns({});
  for (size_t i = 0; i < samples.size(); ++i) {
    const double yaw_rad = 0.05 * static_cast<double>(i);
    samples[i].map_from_base = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
    samples[i].odom_yaw_rad = yaw_rad;
  }
  EXPECT_FALSE(EstimateOdometryDelay(samples).has_value());
}

TEST(EstimateOdometryDelay, RefusesPausesBetweenFrames) {
  TurnOptions options;
  options.step_s = 2.0;
  EXPECT_FALSE(DelayOf(options).has_value());
}

TEST(EstimateOdometryDelay, RefusesWheelsThatTellSomethingElse) {
  TurnOptions options;
  std::vector<TurnSample> samples = MakeTurns(options);
  Rng rng(5);
  for (TurnSample& sample : samples) sample.odom_yaw_rad = rng.Gaussian();
  EXPECT_FALSE(EstimateOdometryDelay(samples).has_value());
}

TEST(EstimateOdometryDelay, RefusesEmptyInput) {
  EXPECT_FALSE(EstimateOdometryDelay({}).has_value());
  EXPECT_FALSE(EstimateOdometryDelay(MakeTurns({}, 10)).has_value());
}

}  // namespace
}  // namespace rovio_sfm
