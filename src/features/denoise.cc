#include "rovio_sfm/features/denoise.h"

#include <opencv2/imgproc.hpp>

namespace rovio_sfm {

cv::Mat Denoise(const cv::Mat& bgr, const DenoiseOptions& options) {
  if (!options.enabled || bgr.empty()) return bgr;
  cv::Mat result;
  cv::bilateralFilter(bgr, result, options.diameter_px, options.sigma_color,
                      options.sigma_space_px);
  return result;
}

}  // namespace rovio_sfm
