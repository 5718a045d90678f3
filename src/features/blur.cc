#include "rovio_sfm/features/blur.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rovio_sfm {

double SharpnessScore(const cv::Mat& grey) {
  if (grey.empty()) return 0.0;
  cv::Mat smooth, laplacian;
  cv::GaussianBlur(grey, smooth, cv::Size(3, 3), 0.8);
  cv::Laplacian(smooth, laplacian, CV_16S);
  return cv::norm(laplacian, cv::NORM_L2) / std::sqrt(static_cast<double>(laplacian.total()));
}

}  // namespace rovio_sfm
