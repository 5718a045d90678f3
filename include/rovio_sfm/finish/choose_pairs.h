#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

struct PairChoiceOptions {
  size_t max_predecessors = 8;  // k: images before it in its drive
  size_t max_overlaps = 4;      // images elsewhere: of other drives, or earlier in its own
  size_t min_common = 15;       // points that an overlap shares
};

// By image of a model: the earlier images of the model that it is to be matched with, the last
// first: its predecessors in its drive and its overlaps (Algorithm 3), each overlap also with the
// predecessors of the other. No pair comes twice.
std::vector<std::vector<uint32_t>> ChoosePairs(const MapModel& model,
                                               const PairChoiceOptions& options);

}  // namespace rovio_sfm
