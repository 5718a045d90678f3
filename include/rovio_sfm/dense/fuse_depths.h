#pragma once

#include <vector>

#include "rovio_sfm/dense/depth_view.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

struct FusionOptions {
  double voxel = 0.02;          // edge, map units
  double free_gap = 0.05;       // relative: a view that sees so much farther looks through
  double max_free_share = 1.0;  // of views that look through a point, to those that found it
};

// Depth maps, already checked, as one cloud: a point a voxel, the mean of what views found in it at
// their pixels that tell (CV_8U, not 0), with normal and colour; points that views look through are
// carved away. By voxel, so that the order depends on nothing else.
PointCloud FuseDepths(const std::vector<DepthView>& views, const std::vector<DepthMap>& depths,
                      const std::vector<cv::Mat>& telling, const FusionOptions& options);

}  // namespace rovio_sfm
