#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

struct JoinedTracks {
  std::vector<std::vector<ModelView>> tracks;  // of two images and more; views by image
  uint32_t num_refused_f1 = 0;                 // matches that filter f1 dropped
};

// The tracks over all images of a model (§3.6): what its points see belongs together, the matches
// join more to it. pairs: by image, those with earlier images, their other_index being the model's
// index of it. Every view of a point is in a track, two in one where nothing forbids it.
JoinedTracks JoinTracks(const MapModel& model, const std::vector<std::vector<PairMatches>>& pairs,
                        double same_feature_px);

}  // namespace rovio_sfm
