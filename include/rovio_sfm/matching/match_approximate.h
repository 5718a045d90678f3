#pragma once

#include <vector>

#include "rovio_sfm/matching/match_options.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// MatchDescriptors by FLANN's trees, for L2 descriptors; a and b hold at least one descriptor of
// the same length. Seeded: the same input and options give the same matches.
std::vector<FeatureMatch> MatchApproximately(const Descriptors& a, const Descriptors& b,
                                             const MatchOptions& options);

}  // namespace rovio_sfm
