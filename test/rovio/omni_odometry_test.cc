#include "rovio_sfm/rovio/omni_odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

// One tick is a tenth of a millimetre here, so that rounding hides nothing.
OmniOdometryOptions FineOptions() {
  OmniOdometryOptions options;
  options.ticks_per_m = 10000.0;
  return options;
}

// Ticks of a rim travel: backward is byte 2.
WheelTicks TicksOf(double rim_m, const OmniOdometryOptions& options) {
  return {static_cast<uint8_t>(rim_m < 0.0 ? 0x02 : 0x05),
          static_cast<uint16_t>(std::lround(std::abs(rim_m) * options.ticks_per_m))};
}

// What the wheels measure, from first principles: velocity of the wheel's place on the base along
// its rolling direction. Left wheel at 60 deg, right at -60 deg, rear at 180 deg.
std::array<WheelTicks, 3> WheelsOf(const BaseMotion& motion, const OmniOdometryOptions& options) {
  const std::array<double, 3> place_rad = {M_PI / 3, -M_PI / 3, M_PI};
  const std::array<double, 3> rolling_rad = {-M_PI / 6, M_PI / 6, M_PI / 2};
  std::array<WheelTicks, 3> wheels;
  for (size_t i = 0; i < 3; ++i) {
    const double x = options.wheel_distance_m * std::cos(place_rad[i]);
    const double y = options.wheel_distance_m * std::sin(place_rad[i]);
    const double forward = motion.x() - motion.z() * y;
    const double left = motion.y() + motion.z() * x;
    wheels[i] =
        TicksOf(forward * std::cos(rolling_rad[i]) + left * std::sin(rolling_rad[i]), options);
  }
  return wheels;
}

TEST(OmniOdometry, RecoversEveryMotionFromItsTicks) {
  const OmniOdometryOptions options = FineOptions();
  const OmniOdometry odometry(options);
  for (const BaseMotion& motion :
       {BaseMotion(0.1, 0, 0), BaseMotion(-0.1, 0, 0), BaseMotion(0, 0.1, 0),
        BaseMotion(0, -0.1, 0), BaseMotion(0, 0, 0.5), BaseMotion(0, 0, -0.5),
        BaseMotion(0.1, -0.2, 0.3)}) {
    const BaseMotion found = odometry.MotionFromTicks(WheelsOf(motion, options));
    EXPECT_LT((found - motion).norm(), 2e-3) << motion.transpose();
  }
}

TEST(OmniOdometry, HasAboutTheTicksOfARealRobot) {
  const OmniOdometryOptions options;
  const auto forward = WheelsOf({1, 0, 0}, options);
  EXPECT_NEAR(forward[0].ticks, 403, 1);
  EXPECT_NEAR(forward[1].ticks, 403, 1);
  EXPECT_EQ(forward[2].ticks, 0);
  const auto turn = WheelsOf({0, 0, 1}, options);
  EXPECT_NEAR(turn[0].ticks + turn[1].ticks + turn[2].ticks, 202, 2);
}

TEST(OmniOdometry, ClosesACircleDrivenSidewaysWhileTurning) {
  const OmniOdometryOptions options = FineOptions();
  OmniOdometry odometry(options);
  const int num_steps = 100;
  for (int i = 0; i < num_steps; ++i) {
    odometry.Add(WheelsOf({0, -2 * M_PI / num_steps, 2 * M_PI / num_steps}, options));
  }
  EXPECT_NEAR(odometry.State().x_m, 0.0, 0.01);
  EXPECT_NEAR(odometry.State().y_m, 0.0, 0.01);
  EXPECT_NEAR(odometry.State().yaw_rad, 2 * M_PI, 0.02);
}

TEST(OmniOdometry, ObeysSignsAndScales) {
  OmniOdometryOptions options = FineOptions();
  options.wheel_sign = {-1, -1, -1};
  options.forward_scale = 2.0;
  const OmniOdometry odometry(options);
  const BaseMotion found = odometry.MotionFromTicks(WheelsOf({0.1, 0.1, 0.2}, options));
  EXPECT_NEAR(found.x(), -0.2, 1e-3);
  EXPECT_NEAR(found.y(), -0.1, 1e-3);
  EXPECT_NEAR(found.z(), -0.2, 2e-3);
}

TEST(OmniOdometry, GrowsUncertainWithTheDistanceAndMoreSideways) {
  const OmniOdometryOptions options = FineOptions();
  OmniOdometry forward(options), sideways(options);
  for (int i = 0; i < 50; ++i) {
    forward.Add(WheelsOf({0.1, 0, 0}, options));
    sideways.Add(WheelsOf({0, 0.1, 0}, options));
  }
  const double forward_sigma_m = std::sqrt(forward.State().covariance(0, 0));
  const double sideways_sigma_m = std::sqrt(sideways.State().covariance(1, 1));
  EXPECT_GT(forward_sigma_m, 5.0 * options.forward_gain_sigma);  // the gain acts on all 5 m
  EXPECT_LT(forward_sigma_m, 5.0 * options.forward_gain_sigma * 1.5);
  EXPECT_GT(sideways_sigma_m, 4.0 * forward_sigma_m);
}

TEST(OmniOdometry, StandsStillWithoutGrowingUncertain) {
  OmniOdometry odometry({});
  for (int i = 0; i < 1000; ++i) odometry.Add({});
  EXPECT_EQ(odometry.State().covariance, Eigen::Matrix3d::Zero());
  EXPECT_EQ(odometry.State().x_m, 0.0);
}

TEST(OmniOdometry, ALostReadingMakesItUncertainNotMoving) {
  OmniOdometry odometry({});
  odometry.AddLostReading(1.0);
  EXPECT_EQ(odometry.State().x_m, 0.0);
  EXPECT_NEAR(std::sqrt(odometry.State().covariance(0, 0)), 0.3, 1e-9);
}

TEST(OmniOdometryOptions, NamesWhatIsOutOfRange) {
  std::string error;
  OmniOdometryOptions options;
  EXPECT_TRUE(IsValid(options, &error));
  options.wheel_sign[1] = 0;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "wheel_sign = [1, 0, 1]: expected three times 1 or -1");
}

}  // namespace
}  // namespace rovio_sfm
