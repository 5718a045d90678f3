#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/matching/match_pair.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// The decoded image with its keypoints; those that belong to a track of an earlier frame stand out.
cv::Mat DrawKeypoints(const cv::Mat& bgr, const FrameEvent& event);

// An earlier keyframe (left) and this one (right) with the matches that each filter let through:
// red until the percentile filter, yellow until RANSAC, green to the end; with the counts of Table
// 3.2. `pair` is of the event; the filters before RANSAC are run again, so this takes a while.
cv::Mat DrawMatches(const cv::Mat& other_bgr, const FrameFeatures& other, const cv::Mat& bgr,
                    const FrameFeatures& features, const PairMatches& pair,
                    const PairOptions& options);

}  // namespace rovio_sfm
