#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "rovio_sfm/features/sift_octaves.h"

namespace rovio_sfm {

// Sets the angle of each keypoint of FindSiftKeypoints (degrees, from x towards y): the strongest
// direction of the gradients around it.
void OrientSift(const std::vector<SiftOctave>& octaves, std::vector<cv::KeyPoint>* keypoints);

// Lowe's descriptors of oriented keypoints, a row each: 128 whole numbers of 0 to 255 (CV_32F), in
// OpenCV's order.
cv::Mat DescribeSift(const std::vector<SiftOctave>& octaves,
                     const std::vector<cv::KeyPoint>& keypoints);

}  // namespace rovio_sfm
