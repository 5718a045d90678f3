#include "rovio_sfm/sim/tour/audit_world.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm::sim {
namespace {

constexpr double kLookDistance_m = 2.0;

// Fits log amplitude over log frequency by least squares.
class LineFit {
 public:
  void Add(double x, double y) {
    count_ += 1.0;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
  }
  double Slope() const { return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_); }

 private:
  double count_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

// The squared spectrum of a windowed square of side px from the middle.
cv::Mat PowerSpectrum(const cv::Mat& rgb, int side) {
  const cv::Rect middle((rgb.cols - side) / 2, (rgb.rows - side) / 2, side, side);
  cv::Mat grey, window, spectrum;
  cv::cvtColor(rgb(middle), grey, cv::COLOR_RGB2GRAY);
  grey.convertTo(grey, CV_32F);
  grey -= cv::mean(grey);
  cv::createHanningWindow(window, grey.size(), CV_32F);
  cv::dft(grey.mul(window), spectrum, cv::DFT_COMPLEX_OUTPUT);
  std::vector<cv::Mat> parts;
  cv::split(spectrum, parts);
  return parts[0].mul(parts[0]) + parts[1].mul(parts[1]);
}

AuditFigures AuditTextures(const World& world) {
  const double pixel_m = kLookDistance_m / RovioCamera().MeanFocal();
  int natural = 0;
  double whitest = -10.0, finest = 0.0, coarsest = 1e9;
  for (const Texture& texture : world.textures()) {
    const double slope = SpectrumSlope(texture.rgb());
    if (slope > -2.0 && slope < -0.6) ++natural;
    whitest = std::max(whitest, slope);
    finest = std::max(finest, pixel_m / texture.texel_m());
    coarsest = std::min(coarsest, pixel_m / texture.texel_m());
  }
  return {AtLeast("textures", static_cast<double>(world.textures().size()), 12),
          AtLeast("textures with a natural spectrum (slope -2.0 to -0.6)", natural, 12),
          Within("slope of the whitest texture's spectrum", whitest, -10.0, -0.3),
          Within("texels per pixel at 2 m, coarsest texture", coarsest, 0.5, 2.0),
          Within("texels per pixel at 2 m, finest texture", finest, 0.5, 2.0)};
}

// How far the greatest face outgrows its texture; above 1 it would have to be tiled.
double GreatestWindow(const World& world) {
  double greatest = 0.0;
  for (const Surface& surface : world.surfaces()) {
    if (surface.texture < 0) continue;
    const cv::Size size = world.textures()[static_cast<size_t>(surface.texture)].size_px();
    for (const Eigen::Vector2f& texel : surface.texels) {
      greatest = std::max({greatest, texel.x() / static_cast<double>(size.width),
                           texel.y() / static_cast<double>(size.height)});
    }
  }
  return greatest;
}

bool IsPeriodic(const TextureSpec& texture) {
  const std::set<std::string> periodic = {"tiles", "bricks", "holes"};
  return std::any_of(texture.marks.begin(), texture.marks.end(),
                     [&](const std::string& mark) { return periodic.count(mark) == 1; });
}

bool IsThinLeg(const PartSpec& part) {
  return part.shape == PartShape::kBox && part.size_m.x() <= 0.04 && part.size_m.y() <= 0.04 &&
         part.size_m.z() >= 0.3;
}

struct PartCounts {
  int pairs = 0, legs = 0, glossy = 0, mirrors = 0, periodic = 0;
};

PartCounts CountParts(const WorldSpec& spec) {
  std::set<std::string> periodic;
  for (const TextureSpec& texture : spec.textures) {
    if (IsPeriodic(texture)) periodic.insert(texture.name);
  }
  PartCounts counts;
  for (const ObjectSpec& object : spec.objects) {
    const int copies = static_cast<int>(object.world_from_object.size());
    counts.pairs += copies * (copies - 1) / 2;
    for (const PartSpec& part : object.parts) {
      counts.legs += IsThinLeg(part) ? copies : 0;
      counts.glossy += part.gloss >= 0.3 ? copies : 0;
      counts.mirrors += part.mirror >= 0.7 ? copies : 0;
      counts.periodic += periodic.count(part.texture) == 1 ? copies : 0;
    }
  }
  return counts;
}

}  // namespace

double SpectrumSlope(const cv::Mat& rgb) {
  const int side = std::min({512, rgb.cols, rgb.rows}) / 2 * 2;
  ROVIO_CHECK(side >= 128);
  const cv::Mat power = PowerSpectrum(rgb, side);
  std::vector<double> sums(static_cast<size_t>(side), 0.0), counts(static_cast<size_t>(side), 0.0);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const double radius = std::hypot(std::min(row, side - row), std::min(col, side - col));
      sums[static_cast<size_t>(radius)] += power.at<float>(row, col);
      counts[static_cast<size_t>(radius)] += 1.0;
    }
  }
  LineFit fit;
  // Rings at even steps of log frequency, so that the many fine ones do not outvote the rest.
  for (double radius = side / 64.0; radius <= side / 4.0; radius *= 1.15) {
    const size_t ring = static_cast<size_t>(radius);
    const double amplitude = std::sqrt(sums[ring] / std::max(counts[ring], 1.0));
    fit.Add(std::log(radius), std::log(amplitude + 1e-9));
  }
  return fit.Slope();
}

AuditFigures AuditWorld(const World& world) {
  AuditFigures figures = AuditTextures(world);
  const PartCounts counts = CountParts(world.spec());
  double smallest_lamp_m = 1e9;
  for (const LightSpec& light : world.spec().lights) {
    smallest_lamp_m = std::min(smallest_lamp_m, light.size_m.minCoeff());
  }
  figures.push_back(
      Within("greatest face over its texture (never tiled)", GreatestWindow(world), 0.0, 1.0001));
  figures.push_back(AtLeast("pairs of identical objects", counts.pairs, 3));
  figures.push_back(AtLeast("periodic surfaces", counts.periodic, 1));
  figures.push_back(AtLeast("thin legs", counts.legs, 4));
  figures.push_back(AtLeast("glossy surfaces", counts.glossy, 1));
  figures.push_back(AtLeast("mirror-like surfaces", counts.mirrors, 1));
  figures.push_back(AtLeast("lamps", static_cast<double>(world.spec().lights.size()), 1));
  figures.push_back(AtLeast("smallest side of a lamp (soft shadows), m", smallest_lamp_m, 0.1));
  return figures;
}

}  // namespace rovio_sfm::sim
