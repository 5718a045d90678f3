#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/sfm/adjust_bundle.h"
#include "rovio_sfm/sfm/feature_noise.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {

// As strict as mapping is (config/mapping.yaml: noise, triangulate, prune), in parallax stricter.
struct GrowOptions {
  FeatureNoise noise;
  LandmarkLimits triangulate = {0.044, 4.0};  // 2.5 deg, 4 sigma
  size_t min_views = 2;                       // of an added point
  BundleOptions adjust;
  double max_error_sigmas = 4.0;  // tau_r: a worse view goes after the adjustment
};

// Gives the free views of each track to the point of the track that they fit, and makes points of
// those that are left and agree, as many as there are. Those are put after the points that were
// there. Returns how many tracks without a point gave none.
size_t AddPoints(const std::vector<std::vector<ModelView>>& tracks, const GrowOptions& options,
                 MapModel* model);

// Adjusts the points alone, the poses fixed, those that a drive saw first at a time (§4.4). Then
// removes views with a large reprojection error, and of the points from num_kept on those left with
// too few views or too little parallax; one before them that is left with fewer than two stays as
// it was. Returns how many points were removed.
size_t AdjustPoints(size_t num_kept, const GrowOptions& options, MapModel* model);

}  // namespace rovio_sfm
