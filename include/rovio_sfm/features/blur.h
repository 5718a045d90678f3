#pragma once

#include <opencv2/core.hpp>

namespace rovio_sfm {

// Sharpness of an 8-bit grey image, higher is sharper: the RMS of the Laplacian after a light
// smoothing, so that noise counts little, in grey levels. Comparable only within one drive.
double SharpnessScore(const cv::Mat& grey);

}  // namespace rovio_sfm
