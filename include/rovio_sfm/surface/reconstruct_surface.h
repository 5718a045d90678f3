#pragma once

#include <cstddef>
#include <functional>

#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

struct SurfaceOptions {
  int outlier_neighbors = 16;    // of the k-nearest-neighbour filter
  double outlier_sigmas = 2.0;   // a point farther from its neighbours than mean + so many: dropped
  double radius_spacings = 4.0;  // radius outlier removal, in median spacings of the cloud
  int min_in_radius = 4;         // points that must lie within
  double smoothing_spacings = 4.0;  // radius of the MLS surface
  int poisson_depth = 9;            // of its octree
  double trim_spacings = 4.0;  // a corner of the mesh farther from every point: unseen, cut away
  size_t min_part = 200;       // triangles; smaller parts are specks
};

constexpr size_t kSurfaceSteps = 4;  // outliers, smoothing, Poisson, trimming
// Told after each step; false ends the work, and nothing is made.
using SurfaceProgress = std::function<bool(size_t num_done, size_t num_steps)>;

// A surface through a cloud (§3.9.1): outliers removed by radius and by k nearest neighbours,
// positions smoothed and normals estimated by moving least squares (turned as the cloud's own are,
// where they are known), Poisson's surface, trimmed to where points are. Corners have the colour of
// the nearest point. Empty for fewer than 100 points, and where the progress ended it.
TriangleMesh ReconstructSurface(const PointCloud& cloud, const SurfaceOptions& options,
                                const SurfaceProgress& progress = {});

}  // namespace rovio_sfm
