#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Pyramidal Lucas-Kanade flow with a forward-backward check.
struct FlowOptions {
  int window_px = 21;
  int levels = 3;
  double max_backward_error_px = 0.5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("window_px", window_px, 5, 61, "side of the patch");
    table.AddRule("window_px", window_px % 2 == 1, "an odd number");
    table.AddNumber("levels", levels, 0, 6, "of the pyramid above the image");
    table.AddLiveNumber("max_backward_error_px", max_backward_error_px, 0.01, 10.0,
                        "there and back again must end here");
  }
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
