#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rovio_sfm {

// Pyramidal Lucas-Kanade flow with a forward-backward check.
struct FlowOptions {
  int window_px = 21;                  // side of the patch; 5 to 61, odd
  int levels = 3;                      // pyramid levels above the image; 0 to 6
  int max_iterations = 30;             // per level; 1 to 100
  double convergence_px = 0.01;        // step that ends the iteration; 1e-4 to 1
  double max_backward_error_px = 0.5;  // there and back again must end here; 0.01 to 10
  double min_eigenvalue = 1e-4;        // least texture of a patch (OpenCV's scale); 0 to 1

  bool IsValid(std::string* error) const;
};

// An image prepared for flow.
struct FlowPyramid {
  std::vector<cv::Mat> levels;
  cv::Size size;  // of the image
};

FlowPyramid BuildFlowPyramid(const cv::Mat& grey, const FlowOptions& options);

// Where each point of image a lies in image b, starting the search at the guesses (one per point,
// or none: the points themselves); nothing where it is lost, leaves the image or fails the check.
std::vector<std::optional<cv::Point2f>> TrackPoints(const FlowPyramid& a, const FlowPyramid& b,
                                                    const std::vector<cv::Point2f>& points_in_a,
                                                    const std::vector<cv::Point2f>& guesses_in_b,
                                                    const FlowOptions& options);

}  // namespace rovio_sfm
