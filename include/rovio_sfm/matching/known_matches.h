#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// Which of the features of one side (&FeatureMatch::a or b) are in a match.
std::vector<bool> UsedFeatures(size_t num_features, const std::vector<FeatureMatch>& known,
                               uint32_t FeatureMatch::*side);

// Of descriptors; of one match or more.
float MeanDistance(const std::vector<FeatureMatch>& matches);

}  // namespace rovio_sfm
