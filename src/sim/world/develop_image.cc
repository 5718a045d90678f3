#include "rovio_sfm/sim/world/develop_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/sim/world/pixel_hash.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kCurveSteps = 4096;
constexpr int kLeastQuality = 10, kQualityStep = 5;

// Grey levels of linear light 0 … 1.
std::array<float, kCurveSteps + 1> MakeSrgbCurve() {
  std::array<float, kCurveSteps + 1> curve{};
  for (int i = 0; i <= kCurveSteps; ++i) {
    const double x = static_cast<double>(i) / kCurveSteps;
    const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    curve[static_cast<size_t>(i)] = static_cast<float>(255.0 * y);
  }
  return curve;
}

// JPEG throws away part of the noise, the more the lower its quality, and demosaicing averages it;
// so more is put in than shall be found in the decoded picture. Measured with this encoder for a
// sigma of about 10.
double InjectedSigma(const DevelopOptions& options) {
  constexpr int kFaithfulQuality = 80;
  const int lost = std::max(kFaithfulQuality - options.jpeg_quality, 0);
  const double factor = options.sensor == Sensor::kBayer ? 1.69 + 0.0052 * lost : 1.0 + 0.01 * lost;
  return options.noise_sigma * factor;
}

// Light that every channel shares (the sensor's read noise after demosaicing), with little colour.
struct Noise {
  float grey, red, blue;
};

Noise NoiseOfPixel(uint64_t seed, int row, int col, double sigma) {
  const uint64_t hash = HashPixel(seed, static_cast<uint32_t>(row), static_cast<uint32_t>(col), 77);
  const double radius =
      std::sqrt(-2.0 * std::log((static_cast<double>(hash >> 40) + 1.0) / 16777217.0));
  const double angle = 2.0 * M_PI * static_cast<double>(hash & 0xffffff) / 16777216.0;
  const float first = static_cast<float>(sigma * radius * std::cos(angle));
  const float second = static_cast<float>(sigma * radius * std::sin(angle));
  return {first, 0.3f * second, -0.3f * second};
}

constexpr double kMiddleGrey = 0.18;  // of the light that metering wants in the mean

// A camera's exposure reacts to the picture, but not wholly: dark rooms stay darker.
double MeteredGain(const cv::Mat& linear_rgb, double metering) {
  if (metering == 0.0) return 1.0;
  const cv::Scalar mean = cv::mean(linear_rgb);
  const double light = std::max((mean[0] + mean[1] + mean[2]) / 3.0, 1e-4);
  return std::pow(kMiddleGrey / light, metering);
}

// Grey levels before noise, RGB.
cv::Mat Expose(const cv::Mat& linear_rgb, double exposure, double vignetting) {
  static const std::array<float, kCurveSteps + 1> curve = MakeSrgbCurve();
  const double center_x = 0.5 * linear_rgb.cols, center_y = 0.5 * linear_rgb.rows;
  const double corner = center_x * center_x + center_y * center_y;
  cv::Mat levels(linear_rgb.size(), CV_32FC3);
  for (int row = 0; row < levels.rows; ++row) {
    for (int col = 0; col < levels.cols; ++col) {
      const double r2 = ((col - center_x) * (col - center_x) + (row - center_y) * (row - center_y));
      const double gain = exposure * (1.0 - vignetting * r2 / corner) * kCurveSteps;
      const cv::Vec3f& light = linear_rgb.at<cv::Vec3f>(row, col);
      for (int c = 0; c < 3; ++c) {
        const int step = static_cast<int>(std::clamp(gain * light[c], 0.0, double{kCurveSteps}));
        levels.at<cv::Vec3f>(row, col)[c] = curve[static_cast<size_t>(step)];
      }
    }
  }
  return levels;
}

cv::Mat SeePlain(const cv::Mat& levels, double sigma, uint64_t seed) {
  cv::Mat bgr(levels.size(), CV_8UC3);
  for (int row = 0; row < bgr.rows; ++row) {
    for (int col = 0; col < bgr.cols; ++col) {
      const Noise noise = sigma > 0.0 ? NoiseOfPixel(seed, row, col, sigma) : Noise{0, 0, 0};
      const float offset[] = {noise.grey + noise.red, noise.grey, noise.grey + noise.blue};
      for (int c = 0; c < 3; ++c) {
        bgr.at<cv::Vec3b>(row, col)[2 - c] =
            cv::saturate_cast<uint8_t>(levels.at<cv::Vec3f>(row, col)[c] + offset[c]);
      }
    }
  }
  return bgr;
}

// Rows of red and green, then of green and blue.
cv::Mat SeeThroughBayer(const cv::Mat& levels, double sigma, uint64_t seed) {
  cv::Mat mosaic(levels.size(), CV_8UC1);
  for (int row = 0; row < mosaic.rows; ++row) {
    for (int col = 0; col < mosaic.cols; ++col) {
      const float noise = sigma > 0.0 ? NoiseOfPixel(seed, row, col, sigma).grey : 0.0f;
      const int color = row % 2 + col % 2;
      mosaic.at<uint8_t>(row, col) =
          cv::saturate_cast<uint8_t>(levels.at<cv::Vec3f>(row, col)[color] + noise);
    }
  }
  cv::Mat bgr;
  cv::cvtColor(mosaic, bgr, cv::COLOR_BayerBG2BGR);  // OpenCV names the second row
  return bgr;
}

}  // namespace

DevelopOptions RobotDevelopOptions() {
  DevelopOptions options;
  options.sensor = Sensor::kBayer;
  options.lens_sigma_px = 0.8;
  options.metering = 0.6;
  options.jpeg_quality = 45;
  return options;
}

bool DevelopOptions::IsValid(std::string* error) const {
  OptionChecker check("develop", error);
  check.Range("lens_sigma_px", lens_sigma_px, 0.0, 5.0);
  check.Range("metering", metering, 0.0, 1.0);
  check.Range("noise_sigma", noise_sigma, 0.0, 25.0);
  check.Range("vignetting", vignetting, 0.0, 0.9);
  check.Range("jpeg_quality", jpeg_quality, 10, 100);
  check.Range("max_bytes", max_bytes, size_t{4096}, size_t{1} << 24);
  return check.Passed();
}

cv::Mat DevelopImage(const cv::Mat& linear_rgb, double exposure, const DevelopOptions& options,
                     uint64_t seed) {
  ROVIO_CHECK(linear_rgb.type() == CV_32FC3 && options.IsValid(nullptr));
  cv::Mat light = linear_rgb;
  if (options.lens_sigma_px > 0.0) {
    cv::GaussianBlur(linear_rgb, light, cv::Size(), options.lens_sigma_px);
  }
  const double gain = exposure * MeteredGain(linear_rgb, options.metering);
  const cv::Mat levels = Expose(light, gain, options.vignetting);
  const double sigma = InjectedSigma(options);
  return options.sensor == Sensor::kBayer ? SeeThroughBayer(levels, sigma, seed)
                                          : SeePlain(levels, sigma, seed);
}

std::vector<uint8_t> EncodeJpeg(const cv::Mat& bgr, const DevelopOptions& options) {
  const auto encode = [&](int steps) {
    std::vector<uint8_t> bytes;
    const int quality = options.jpeg_quality - kQualityStep * steps;
    ROVIO_CHECK(cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality}));
    return bytes;
  };
  std::vector<uint8_t> best = encode(0);
  if (best.size() <= options.max_bytes) return best;
  int too_fine = 0, coarse = (options.jpeg_quality - kLeastQuality) / kQualityStep;
  best = encode(coarse);
  while (coarse - too_fine > 1) {  // sizes fall with the quality
    const int middle = (too_fine + coarse) / 2;
    std::vector<uint8_t> bytes = encode(middle);
    const bool fits = bytes.size() <= options.max_bytes;
    (fits ? coarse : too_fine) = middle;
    if (fits) best = std::move(bytes);
  }
  return best;
}

}  // namespace rovio_sfm::sim
