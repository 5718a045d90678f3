#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace rovio_sfm {

// The bilateral filter before extraction (§3.3).
struct DenoiseOptions {
  bool enabled = true;
  int diameter_px = 3;           // 3 to 15, odd; the thesis's value
  double sigma_color = 50.0;     // grey levels, 1 to 255; the thesis's value
  double sigma_space_px = 50.0;  // 0.1 to 200; the thesis's value

  bool IsValid(std::string* error) const;
};

// The image with noise reduced and edges kept; the image itself (shared) where it is off.
cv::Mat Denoise(const cv::Mat& bgr, const DenoiseOptions& options);

}  // namespace rovio_sfm
