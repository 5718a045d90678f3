#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "rovio_sfm/dense/check_depth.h"
#include "rovio_sfm/dense/estimate_depth.h"
#include "rovio_sfm/dense/fuse_depths.h"
#include "rovio_sfm/dense/most_certain.h"
#include "rovio_sfm/dense/smooth_depth.h"
#include "rovio_sfm/finish/choose_neighbors.h"
#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/point_cloud.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {

struct DenseOptions {
  NeighborOptions neighbors;
  SweepOptions sweep;
  AgreementOptions agreement;
  SmoothingOptions smoothing;
  CertaintyOptions certainty;
  FusionOptions fusion;  // its voxel is voxel_share of the median depth
  double voxel_share = 1.0 / 240.0;
};

// The encoded picture of an image; null where it is not kept.
using ReadPicture =
    std::function<std::shared_ptr<const std::vector<uint8_t>>(const ModelImage& image)>;
// Told after each image of a step, which there may be several of; false ends the work, and nothing
// is made.
using DenseProgress = std::function<bool(size_t num_done, size_t num_total)>;

// A dense cloud of a map in its level frame (design 5.5): a depth map of every keyframe whose
// picture is kept, what many views agree on, on its surface, told by who sees it best, fused. The
// bytes do not depend on the threads. Throws std::runtime_error where no picture is kept, or one is
// none of its camera.
PointCloud MakeDenseCloud(const MapModel& model, const ReadPicture& read,
                          const DenseOptions& options, Executor* executor,
                          const DenseProgress& progress = {});

}  // namespace rovio_sfm
