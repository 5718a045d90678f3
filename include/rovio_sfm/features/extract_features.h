#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/features/extract_options.h"
#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// Finds evenly spread features in a raw (distorted) 8-bit BGR image of the camera's size and
// describes them (§3.3): keypoints in raw pixels, undistorted points (features that cannot be
// undistorted are dropped), colours, descriptors as bytes. At most options.max_features, ordered by
// row, then column. Pure and deterministic.
FrameFeatures ExtractFeatures(const cv::Mat& bgr, const Camera& camera,
                              const ExtractOptions& options);

}  // namespace rovio_sfm
