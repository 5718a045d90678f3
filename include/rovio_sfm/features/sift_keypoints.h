#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "rovio_sfm/features/sift_octaves.h"

namespace rovio_sfm {

struct SiftKeypointOptions {
  double contrast = 0.004;  // least, of a full one, times kSiftLayers
  double edge = 10.0;       // greatest ratio of the curvatures
};

// The extrema of the differences of neighbouring images, refined below a pixel (Lowe 2004), in
// pixels of the picture, without an angle. `octave` and `class_id` of a keypoint say which octave
// and which of its images it is from; `size` is twice its scale.
std::vector<cv::KeyPoint> FindSiftKeypoints(const std::vector<SiftOctave>& octaves,
                                            const SiftKeypointOptions& options);

// The corners (Shi and Tomasi 1994) of the finest octave, the strongest first, for pictures whose
// extrema do not suffice: refined below a pixel, with the scale of that octave's first image with
// features. Two may be refined to one place.
std::vector<cv::KeyPoint> FindCorners(const SiftOctave& finest, double min_distance_px);

}  // namespace rovio_sfm
