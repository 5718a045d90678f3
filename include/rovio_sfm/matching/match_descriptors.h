#pragma once

#include <vector>

#include "rovio_sfm/matching/match_options.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// For each descriptor of b its nearest of a, with the distance and the ratio to the second nearest
// (1 where there is no second; 0/0 counts as 1), in order of b; equal distances go to the smaller
// a. Empty if either is empty or the types differ. No filter is applied. The first call sets
// OpenBLAS to one thread for the whole process. Pure otherwise; exact results are whole-number
// arithmetic.
std::vector<FeatureMatch> MatchDescriptors(const Descriptors& a, const Descriptors& b,
                                           const MatchOptions& options);

}  // namespace rovio_sfm
