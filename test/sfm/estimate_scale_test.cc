#include "rovio_sfm/sfm/estimate_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr double kMetresPerUnit = 0.4;

// A drive of steps of 0.1 m as vision sees it; the wheels measure gain times the way. The heading
// turns by turn_rad a step, the way leads direction_rad off the heading.
struct DriveOptions {
  int num_frames = 40;
  double turn_rad = 0.02;
  double direction_rad = 0.0;
  double gain = 1.0;
  double gain_noise = 0.0;
};

ScaleSample MakeSample(const Eigen::Vector2d& seen_m, const Eigen::Vector2d& measured_m,
                       double yaw_rad) {
  const Eigen::Quaterniond odom_from_base(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond base_from_camera(0.5, -0.5, 0.5, -0.5);
  const Eigen::Quaterniond rotation = odom_from_base * base_from_camera;
  const Eigen::Vector3d center(seen_m.x() / kMetresPerUnit, seen_m.y() / kMetresPerUnit, 0.0);
  ScaleSample sample;
  sample.cam_from_map = Inverse(Rigid3{rotation, center});
  sample.odom_from_camera = {rotation, {measured_m.x(), measured_m.y(), 0.2}};
  sample.yaw_rad = yaw_rad;
  return sample;
}

std::vector<ScaleSample> MakeDrive(const DriveOptions& options) {
  Rng rng(3);
  std::vector<ScaleSample> samples;
  Eigen::Vector2d seen_m(0, 0), measured_m(0, 0);
  for (int i = 0; i < options.num_frames; ++i) {
    const double yaw_rad = i * options.turn_rad;
    samples.push_back(MakeSample(seen_m, measured_m, yaw_rad));
    const double direction = yaw_rad + options.direction_rad;
    const Eigen::Vector2d step = 0.1 * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    seen_m += step;
    measured_m += options.gain * std::exp(options.gain_noise * rng.Gaussian()) * step;
  }
  return samples;
}

TEST(EstimateScale, IsExactWithPerfectOdometry) {
  const auto scale = EstimateScale(MakeDrive({}), {});
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->metres_per_unit, kMetresPerUnit, 1e-9);
  EXPECT_EQ(scale->source, "odometry");
}

TEST(EstimateScale, SigmaNeverFallsBelowTheGainOfTheOdometry) {
  DriveOptions drive;
  drive.num_frames = 400;
  const auto scale = EstimateScale(MakeDrive(drive), {});
  ASSERT_TRUE(scale);
  EXPECT_GE(scale->sigma_log, EstimateScaleOptions{}.gains.forward_sigma);
  EXPECT_LT(scale->sigma_log, 1.2 * EstimateScaleOptions{}.gains.forward_sigma);
}

TEST(EstimateScale, BearsSlip) {
  auto samples = MakeDrive({});
  // The wheels turn on the spot three times: 0.2 m too much each.
  for (const size_t from : {8u, 19u, 30u}) {
    for (size_t i = from; i < samples.size(); ++i) {
      samples[i].odom_from_camera.translation.x() += 0.2;
    }
  }
  const auto scale = EstimateScale(samples, {});
  ASSERT_TRUE(scale);
  EXPECT_LT(std::abs(std::log(scale->metres_per_unit / kMetresPerUnit)), scale->sigma_log);
}

TEST(EstimateScale, ScatterWidensTheSigma) {
  DriveOptions drive;
  drive.gain_noise = 0.2;
  drive.num_frames = 20;
  const auto noisy = EstimateScale(MakeDrive(drive), {});
  drive.gain_noise = 0.0;
  const auto clean = EstimateScale(MakeDrive(drive), {});
  ASSERT_TRUE(noisy && clean);
  EXPECT_GT(noisy->sigma_log, clean->sigma_log);
  EXPECT_LT(std::abs(std::log(noisy->metres_per_unit / kMetresPerUnit)), 3.0 * noisy->sigma_log);
}

// The same drive seen more often: samples between each two.
std::vector<ScaleSample> MakeDense(const std::vector<ScaleSample>& samples, int num_between) {
  std::vector<ScaleSample> dense;
  for (size_t i = 0; i + 1 < samples.size(); ++i) {
    const ScaleSample &from = samples[i], &to = samples[i + 1];
    for (int k = 0; k <= num_between; ++k) {
      const double share = static_cast<double>(k) / (num_between + 1);
      const auto mean = [share](const auto& a, const auto& b) { return a + share * (b - a); };
      const Eigen::Vector3d seen_m =
          kMetresPerUnit * mean(OriginInA(from.cam_from_map), OriginInA(to.cam_from_map));
      const Eigen::Vector3d measured_m =
          mean(from.odom_from_camera.translation, to.odom_from_camera.translation);
      dense.push_back(
          MakeSample(seen_m.head<2>(), measured_m.head<2>(), mean(from.yaw_rad, to.yaw_rad)));
    }
  }
  return dense;
}

TEST(EstimateScale, SigmaDoesNotFallWithTheRateOfFrames) {
  DriveOptions drive;
  drive.gain_noise = 0.2;
  drive.num_frames = 100;
  EstimateScaleOptions options;
  options.gains = {1e-4, 1e-4};  // the scatter alone
  const auto samples = MakeDrive(drive);
  const auto once = EstimateScale(samples, options);
  const auto often = EstimateScale(MakeDense(samples, 9), options);
  ASSERT_TRUE(once && often);
  EXPECT_NEAR(once->sigma_log, often->sigma_log, 0.35 * once->sigma_log);
}

TEST(EstimateScale, BeginsAWindowAtEverySample) {
  DriveOptions drive;
  drive.num_frames = 8;  // 0.7 m: four windows of 0.4 m, one without overlap
  EXPECT_TRUE(EstimateScale(MakeDrive(drive), {}));
}

TEST(EstimateScale, ConfessesTheGainOfForwardMotionInsideTwoSigma) {
  for (const double gain : {0.95, 1.05}) {
    DriveOptions drive;
    drive.gain = gain;
    const auto scale = EstimateScale(MakeDrive(drive), {});
    ASSERT_TRUE(scale);
    EXPECT_NEAR(scale->metres_per_unit, gain * kMetresPerUnit, 1e-9);
    EXPECT_LT(std::abs(std::log(gain)), 2.0 * scale->sigma_log);
  }
}

TEST(EstimateScale, TrustsSidewaysMotionLess) {
  DriveOptions sideways;
  sideways.direction_rad = M_PI / 2.0;
  sideways.gain = 0.8;
  const auto scale = EstimateScale(MakeDrive(sideways), {});
  ASSERT_TRUE(scale);
  EXPECT_LT(std::abs(std::log(scale->metres_per_unit / kMetresPerUnit)), 2.0 * scale->sigma_log);
  // A third of the way forward outweighs two thirds sideways with a bad gain.
  auto samples = MakeDrive(sideways);
  DriveOptions forward;
  forward.num_frames = 20;
  for (ScaleSample sample : MakeDrive(forward)) {
    sample.odom_from_camera.translation.x() += 100.0;
    samples.push_back(sample);
  }
  EXPECT_NEAR(EstimateScale(samples, {})->metres_per_unit, kMetresPerUnit, 1e-9);
}

// What a way between forward and sideways may be too long or short by, against drives with gains
// drawn.
TEST(EstimateScale, SigmaOfASlantingWayIsThatOfItsLength) {
  EstimateScaleOptions options;
  options.gains = {0.02, 0.1};
  DriveOptions slanting;
  slanting.turn_rad = 0.0;
  slanting.direction_rad = 0.35;
  const auto scale = EstimateScale(MakeDrive(slanting), options);
  ASSERT_TRUE(scale);
  Rng rng(5);
  double sum = 0.0;
  constexpr int kDrives = 20000;
  for (int i = 0; i < kDrives; ++i) {
    const double forward_m = std::cos(0.35) * (1.0 + 0.02 * rng.Gaussian());
    const double sideways_m = std::sin(0.35) * (1.0 + 0.1 * rng.Gaussian());
    sum += std::pow(std::log(std::hypot(forward_m, sideways_m)), 2);
  }
  const double sigma = std::sqrt(sum / kDrives);
  EXPECT_NEAR(scale->sigma_log, sigma, 0.03 * sigma);
}

TEST(EstimateScale, PassesOverWindowsWhoseRotationsDisagree) {
  auto samples = MakeDrive({});
  for (size_t i = 10; i < samples.size(); ++i) {  // slips forward while it turns a tenth too far
    samples[i].odom_from_camera.rotation =
        Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()) * samples[i].odom_from_camera.rotation;
    samples[i].odom_from_camera.translation.x() += 0.15;
  }
  EXPECT_NEAR(EstimateScale(samples, {})->metres_per_unit, kMetresPerUnit, 1e-9);
  for (ScaleSample& sample : samples) sample.odom_from_camera.rotation.setIdentity();
  EXPECT_FALSE(EstimateScale(samples, {}));
}

TEST(EstimateScale, AnswersNothingWithoutEnoughMotion) {
  EXPECT_FALSE(EstimateScale({}, {}));
  DriveOptions drive;
  drive.num_frames = 5;  // 0.4 m: two windows
  EXPECT_FALSE(EstimateScale(MakeDrive(drive), {}));
  drive.num_frames = 30;
  drive.gain = 0.0;  // the wheels stand
  EXPECT_FALSE(EstimateScale(MakeDrive(drive), {}));
  drive.gain = 1.0;
  auto samples = MakeDrive(drive);
  for (ScaleSample& sample : samples) sample.cam_from_map = samples[0].cam_from_map;
  EXPECT_FALSE(EstimateScale(samples, {}));  // the camera stands
}

}  // namespace
}  // namespace rovio_sfm
