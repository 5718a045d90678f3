#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace rovio_sfm::sim {

enum class Sensor : uint8_t {
  kPlain = 0,  // sees all three colours in every pixel; its noise is that of the pixel alone
  kBayer =
      1,  // one colour a pixel (RGGB), noise on that, then demosaiced: noise of neighbours is alike
};

// From light to bytes: a cheap lens, its sensor and its JPEG encoder.
struct DevelopOptions {
  Sensor sensor = Sensor::kPlain;
  double lens_sigma_px = 0.0;  // of the lens's blur, a Gaussian, 0 … 5
  double metering = 0.0;  // share of a change of the scene's light that exposure evens out, 0 … 1
  double noise_sigma = 10.0;  // grey levels, of the decoded picture; 0 switches noise off. 0 … 25
  double vignetting = 0.35;   // loss of light in the corners, 0 … 0.9
  int jpeg_quality = 80;      // libjpeg's, 10 … 100; lowered where the picture exceeds max_bytes
  size_t max_bytes = 65536;   // of the robot's encoder buffer

  bool IsValid(std::string* error) const;
};

// As the robot's pictures are (design 5.6): lens blur, Bayer sensor, metering, JPEG of quality 45.
DevelopOptions RobotDevelopOptions();

// Exposure (gain on the linear image), vignetting, sRGB curve, noise: CV_8UC3, BGR. The noise of a
// pixel depends on the seed and its place alone.
cv::Mat DevelopImage(const cv::Mat& linear_rgb, double exposure, const DevelopOptions& options,
                     uint64_t seed);

// JPEG bytes, 4:2:0.
std::vector<uint8_t> EncodeJpeg(const cv::Mat& bgr, const DevelopOptions& options);

}  // namespace rovio_sfm::sim
