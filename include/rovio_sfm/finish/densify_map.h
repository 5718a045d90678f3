#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/finish/choose_pairs.h"
#include "rovio_sfm/finish/gather_features.h"
#include "rovio_sfm/finish/grow_points.h"
#include "rovio_sfm/finish/make_dense_cloud.h"
#include "rovio_sfm/finish/measure_points.h"
#include "rovio_sfm/finish/sound_depths.h"
#include "rovio_sfm/matching/match_posed.h"
#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/point_cloud.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {

struct DensifyOptions {
  PairChoiceOptions pairs;
  GatherOptions gather;
  PosedMatchOptions match;
  double same_feature_px = 1.5;  // filter f1
  GrowOptions grow;
  SoundDepthOptions depth;
};

// The features of an image with their descriptors, as its map's store keeps them, in the order of
// its keypoints; null where they are not kept. Called by one thread at a time.
using ReadFeatures = std::function<std::shared_ptr<const FrameFeatures>(const ModelImage& image)>;

struct DensifyCounts {
  PointFigures before, after;
  size_t num_features = 0;             // of all images
  size_t num_matches = 0;              // within the epipolar bands
  size_t num_refused_f1 = 0;           // of them, by filter f1
  size_t num_barren_tracks = 0;        // whose views agree on no point
  size_t num_removed_points = 0;       // by the reprojection filter after the adjustment
  size_t num_inconsistent_depths = 0;  // added points removed for the depths round them
};

// The points that a model had, in their order, then the added ones.
struct DensifiedMap {
  PointCloud cloud;
  DensifyCounts counts;
};

// Densifies a map (§3.9, §4.4, Algorithm 3), its poses fixed: matches each image with relaxed
// filters against its predecessors and overlaps, with the stored features and, where its picture is
// kept, those found with the larger budget; joins tracks, makes points as strictly as mapping does,
// adjusts the points alone. progress is told after each image, of two passes (read, match); where
// it says false nothing is made. The bytes do not depend on the threads. Throws std::runtime_error
// where no image's features are kept, or a picture is none of its camera.
std::optional<DensifiedMap> DensifyMap(const MapModel& model, const ReadFeatures& features,
                                       const ReadPicture& pictures, const DensifyOptions& options,
                                       Executor* executor, const DenseProgress& progress = {});

// For people, in one sentence: points, projections and RMS_N before and after.
std::string Describe(const DensifyCounts& counts);
// The same as rows of a table: name, and "before → after".
std::vector<std::pair<std::string, std::string>> RowsOf(const DensifyCounts& counts);

}  // namespace rovio_sfm
