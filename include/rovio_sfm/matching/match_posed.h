#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/matching/match_in_range.h"
#include "rovio_sfm/matching/match_options.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// The filters of a pair whose poses are known (§3.9): milder than those of MatchPair, as no pose
// hangs on them.
struct PosedMatchOptions {
  MatchOptions match;
  float max_ratio = 0.95f;  // Lowe's, tau_u
  double band_px = 2.0;     // greatest distance from the epipolar line of the known poses
  RangeMatchOptions range;  // second pass, for features that are left
};

// Matches of an earlier image a with a later one b: nearest descriptors, ratio, one-to-one,
// epipolar band of the known pose; then what MatchInRange finds. No percentile filter and no
// RANSAC. Nothing for poses in one place. other_index is copied into the result; focal_px turns
// pixels into the plane z = 1.
PairMatches MatchPosed(uint32_t other_index, const FrameFeatures& a, const FrameFeatures& b,
                       const Rigid3& b_from_a, const std::vector<DepthRange>& ranges_in_b,
                       double focal_px, const PosedMatchOptions& options);

}  // namespace rovio_sfm
