#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// Descriptors as RootSIFT bytes: 512 * sqrt of the L1-normalised values, rounded (Arandjelovic and
// Zisserman 2012). Row products are whole numbers below 2^24, so that floats multiply them exactly.
// Takes CV_32F, one non-negative SIFT descriptor a row.
Descriptors RootSiftFromSift(const cv::Mat& sift);

}  // namespace rovio_sfm
