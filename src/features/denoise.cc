#include "rovio_sfm/features/denoise.h"

#include <opencv2/imgproc.hpp>

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool DenoiseOptions::IsValid(std::string* error) const {
  OptionChecker checker("denoise", error);
  checker.Range("diameter_px", diameter_px, 3, 15);
  checker.True("diameter_px", diameter_px % 2 == 1, "an odd number");
  checker.Range("sigma_color", sigma_color, 1.0, 255.0);
  checker.Range("sigma_space_px", sigma_space_px, 0.1, 200.0);
  return checker.Passed();
}

cv::Mat Denoise(const cv::Mat& bgr, const DenoiseOptions& options) {
  if (!options.enabled || bgr.empty()) return bgr;
  cv::Mat result;
  cv::bilateralFilter(bgr, result, options.diameter_px, options.sigma_color,
                      options.sigma_space_px);
  return result;
}

}  // namespace rovio_sfm
