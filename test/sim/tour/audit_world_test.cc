#include "rovio_sfm/sim/tour/audit_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "rovio_sfm/util/rng.h"
#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

cv::Mat Noise(double exponent) {
  Rng rng(1);
  cv::Mat white(256, 256, CV_32F), spectrum, field;
  for (float& value : cv::Mat_<float>(white)) value = static_cast<float>(rng.Gaussian());
  cv::dft(white, spectrum, cv::DFT_COMPLEX_OUTPUT);
  for (int row = 0; row < 256; ++row) {
    for (int col = 0; col < 256; ++col) {
      const double radius =
          std::max(1.0, std::hypot(std::min(row, 256 - row), std::min(col, 256 - col)));
      spectrum.at<cv::Vec2f>(row, col) *= static_cast<float>(std::pow(radius, exponent));
    }
  }
  cv::dft(spectrum, field, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  cv::normalize(field, field, 0.0, 255.0, cv::NORM_MINMAX, CV_8U);
  cv::merge(std::vector<cv::Mat>(3, field), field);
  return field;
}

const AuditFigure& Find(const AuditFigures& figures, const std::string& name) {
  for (const AuditFigure& figure : figures) {
    if (figure.name == name) return figure;
  }
  throw std::runtime_error("no figure " + name);
}

TEST(SpectrumSlope, TellsNaturalFromWhiteNoise) {
  EXPECT_NEAR(SpectrumSlope(Noise(0.0)), 0.0, 0.2);
  EXPECT_NEAR(SpectrumSlope(Noise(-1.0)), -1.0, 0.2);
}

TEST(AuditWorld, CountsWhatTheSmallWorldHas) {
  const AuditFigures figures = AuditWorld(World(SmallWorldSpec()));
  EXPECT_EQ(Find(figures, "pairs of identical objects").value, 1.0);
  EXPECT_EQ(Find(figures, "mirror-like surfaces").value, 1.0);
  EXPECT_EQ(Find(figures, "lamps").value, 1.0);
  EXPECT_FALSE(Find(figures, "textures").Holds());
  EXPECT_FALSE(Find(figures, "thin legs").Holds());
}

TEST(AuditFigure, HoldsAtItsBounds) {
  EXPECT_TRUE(AtLeast("a", 3.0, 3.0).Holds());
  EXPECT_FALSE(Within("a", 3.1, 1.0, 3.0).Holds());
  EXPECT_FALSE(Within("a", std::numeric_limits<double>::quiet_NaN(), 1.0, 3.0).Holds());
}

}  // namespace
}  // namespace rovio_sfm::sim
