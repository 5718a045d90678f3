#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace rovio_sfm {

struct SelectOptions {
  int max_keypoints = 1000;
  int max_candidates = 1500;     // strongest ones, after suppression, that take part in the spread
  int cell_px = 48;              // side of a grid cell
  double min_distance_px = 1.5;  // of two nearer keypoints the weaker one goes
  int border_px = 3;             // keypoints nearer to the edge go
  double size_exponent = 0.0;    // strength is response times size to this power
};

// Spreads keypoints evenly: suppresses near duplicates (of equal ones, several orientations of one
// place, the smallest angle stays), keeps the strongest max_candidates, then takes from each grid
// cell its strongest, then its second, and so on. Ties by position. The result is ordered by row,
// then column.
std::vector<cv::KeyPoint> SelectKeypoints(const std::vector<cv::KeyPoint>& candidates,
                                          const cv::Size& image_size, const SelectOptions& options);

// Puts those of `more` behind the keypoints, in their order, that are neither near to one before
// nor to the edge, until there are max_keypoints.
void FillWith(const std::vector<cv::KeyPoint>& more, const cv::Size& image_size,
              const SelectOptions& options, std::vector<cv::KeyPoint>* keypoints);

}  // namespace rovio_sfm
