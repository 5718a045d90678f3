#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "rovio_sfm/features/extract_options.h"
#include "rovio_sfm/features/select_keypoints.h"
#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

struct SurfFeatures {
  std::vector<cv::KeyPoint> keypoints;
  Descriptors descriptors;  // 64 values of [-0.5, 0.5] as bytes 0 … 255
};

// SURF by dlib (Debian's OpenCV has none), on an 8-bit grey image.
SurfFeatures ExtractSurf(const cv::Mat& grey, double threshold, const SelectOptions& select);

}  // namespace rovio_sfm
