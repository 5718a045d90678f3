#pragma once

#include <vector>

#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// Lowe's ratio, τ_u: matches whose nearest is clearly nearer than the second nearest.
std::vector<FeatureMatch> FilterByRatio(const std::vector<FeatureMatch>& matches, float max_ratio);

// The percentile filter of §3.4.2: distance <= τ_κ times the mean distance of the matches.
std::vector<FeatureMatch> FilterByMeanDistance(const std::vector<FeatureMatch>& matches,
                                               float max_factor);

// Of several matches of one feature of a (or of b) the nearest stays, of equals the one with the
// smaller indices. The order is kept.
std::vector<FeatureMatch> FilterOneToOne(const std::vector<FeatureMatch>& matches);

}  // namespace rovio_sfm
