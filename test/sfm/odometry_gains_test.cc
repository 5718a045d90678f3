#include "rovio_sfm/sfm/odometry_gains.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace rovio_sfm {
namespace {

// What a robot of these gains and this noise says of itself: steps of 0.1 m, the first half of them
// forward, the second to the left, the heading turning all the while.
std::vector<OdometrySample> MakeDrive(double forward_gain, double sideways_gain, double noise,
                                      int num_steps = 40) {
  std::vector<OdometrySample> samples;
  Eigen::Vector2d position(1.0, -2.0), forward(0, 0), sideways(0, 0);
  for (int i = 0; i <= num_steps; ++i) {
    const double yaw_rad = 0.4 + 0.01 * i;
    const Eigen::Matrix2d covariance =
        std::pow(forward_gain, 2) * forward * forward.transpose() +
        std::pow(sideways_gain, 2) * sideways * sideways.transpose() +
        noise * noise * 0.1 * i * Eigen::Matrix2d::Identity();
    samples.push_back({position.x(), position.y(), yaw_rad, OdometryCovariance{}});
    OdometryCovariance& c = *samples.back().covariance;
    c[0] = covariance(0, 0), c[1] = c[3] = covariance(0, 1), c[4] = covariance(1, 1);
    const Eigen::Rotation2Dd odom_from_base(yaw_rad + 0.005);  // amid the next step
    const bool is_forward = i < num_steps / 2;
    const Eigen::Vector2d step =
        odom_from_base * (is_forward ? Eigen::Vector2d(0.1, 0.0) : Eigen::Vector2d(0.0, 0.1));
    position += step;
    (is_forward ? forward : sideways) += step;
  }
  return samples;
}

TEST(LearnOdometryGains, AreThoseThatTheCovarianceWasMadeOf) {
  const OdometryGains gains = LearnOdometryGains(MakeDrive(0.11, 0.3, 0.02), {});
  EXPECT_NEAR(gains.forward_sigma, 0.11, 1e-6);
  EXPECT_NEAR(gains.sideways_sigma, 0.3, 1e-6);
}

TEST(LearnOdometryGains, NoiseAloneTellsNoGain) {
  const OdometryGains gains = LearnOdometryGains(MakeDrive(0.0, 0.0, 0.1), {0.05, 0.2});
  EXPECT_EQ(gains.forward_sigma, 0.05);
  EXPECT_EQ(gains.sideways_sigma, 0.2);
}

TEST(LearnOdometryGains, ForwardIsNeverBelowTheLeast) {
  const OdometryGains gains = LearnOdometryGains(MakeDrive(0.01, 0.02, 0.0), {0.05, 0.2});
  EXPECT_EQ(gains.forward_sigma, 0.05);
  EXPECT_EQ(gains.sideways_sigma, 0.05);
}

TEST(LearnOdometryGains, ADirectionThatWasNotDrivenKeepsTheLeast) {
  auto samples = MakeDrive(0.11, 0.3, 0.02);
  samples.resize(samples.size() / 2);
  const OdometryGains gains = LearnOdometryGains(samples, {0.05, 0.2});
  EXPECT_NEAR(gains.forward_sigma, 0.11, 1e-6);
  EXPECT_EQ(gains.sideways_sigma, 0.2);
}

TEST(LearnOdometryGains, UnknownOrConstantCovarianceTellsNothing) {
  auto samples = MakeDrive(0.11, 0.3, 0.02);
  for (OdometrySample& sample : samples) sample.covariance->fill(0.001);
  EXPECT_EQ(LearnOdometryGains(samples, {0.07, 0.2}).forward_sigma, 0.07);
  samples = MakeDrive(0.11, 0.3, 0.02);
  samples[5].covariance.reset();
  EXPECT_EQ(LearnOdometryGains(samples, {0.07, 0.2}).forward_sigma, 0.07);
  EXPECT_EQ(LearnOdometryGains({}, {0.07, 0.2}).sideways_sigma, 0.2);
}

}  // namespace
}  // namespace rovio_sfm
