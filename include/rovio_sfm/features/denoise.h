#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The bilateral filter before extraction (§3.3).
struct DenoiseOptions {
  bool enabled = true;
  int diameter_px = 3;
  double sigma_color = 50.0;
  double sigma_space_px = 50.0;

  void DescribeOptions(OptionTable& table) {
    table.AddFlag("enabled", enabled, "the thesis's values follow");
    table.AddNumber("diameter_px", diameter_px, 3, 15, "");
    table.AddRule("diameter_px", diameter_px % 2 == 1, "an odd number");
    table.AddNumber("sigma_color", sigma_color, 1.0, 255.0, "grey levels");
    table.AddNumber("sigma_space_px", sigma_space_px, 0.1, 200.0, "");
  }
};

// The image with noise reduced and edges kept; the image itself (shared) where it is off.
cv::Mat Denoise(const cv::Mat& bgr, const DenoiseOptions& options);

}  // namespace rovio_sfm
