#include "rovio_sfm/sim/tour/audit_tour.h"

#include <gtest/gtest.h>

#include "rovio_sfm/sim/tour/tour.h"
#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TEST(PlainShare, IsOneForAWallAndNoneForNoise) {
  cv::Mat wall(64, 64, CV_8UC3, cv::Scalar::all(100)), noise(64, 64, CV_8UC3);
  cv::RNG rng(1);
  rng.fill(noise, cv::RNG::UNIFORM, 0, 256);
  EXPECT_EQ(PlainShare(wall), 1.0);
  EXPECT_EQ(PlainShare(noise), 0.0);
}

TEST(DecodedNoise, IsWhatWasAskedFor) {
  EXPECT_NEAR(DecodedNoise({}).sigma, 10.0, 1.0);
  for (const int quality : {60, 70}) {
    DevelopOptions options;
    options.jpeg_quality = quality;
    EXPECT_NEAR(DecodedNoise(options).sigma, 10.0, 1.0) << quality;
  }
}

TEST(DecodedNoise, IsThatOfNeighboursBehindABayerSensor) {
  for (const int quality : {30, 45, 60}) {
    DevelopOptions options = RobotDevelopOptions();
    options.jpeg_quality = quality;
    const NoiseFigures noise = DecodedNoise(options);
    EXPECT_NEAR(noise.sigma, 10.0, 1.0) << quality;
    EXPECT_GT(noise.correlation, 0.3) << quality;
    EXPECT_LT(noise.correlation, 0.7) << quality;
  }
  EXPECT_NEAR(DecodedNoise({}).correlation, 0.0, 0.15);
}

TEST(DecodedNoise, IsNoneWithoutNoise) {
  DevelopOptions options;
  options.noise_sigma = 0.0;
  EXPECT_NEAR(DecodedNoise(options).sigma, 0.0, 1e-3);
}

TEST(AuditTour, NamesWhatASmallTourLacks) {
  const World world(SmallWorldSpec());
  const ImageRenderer renderer(world, SmallCamera(), {});
  AuditTourOptions options;
  options.num_pictures = 2;
  options.depth_step_px = 4;
  const TourSpec tour = ParseTour(SmallTourYaml(), "short");
  int held = 0, fell = 0;
  for (const AuditFigure& figure : AuditTour(renderer, tour, {}, {}, 1, options)) {
    ++(figure.Holds() ? held : fell);
    if (figure.name.find("intrinsics") != std::string::npos) {
      EXPECT_FALSE(figure.Holds());
    }
    if (figure.name.find("seeded apart") != std::string::npos) {
      EXPECT_TRUE(figure.Holds());
    }
  }
  EXPECT_GT(held, 8);
  EXPECT_GT(fell, 0);
}

}  // namespace
}  // namespace rovio_sfm::sim
