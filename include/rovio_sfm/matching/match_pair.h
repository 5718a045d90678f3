#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/matching/match_descriptors.h"
#include "rovio_sfm/matching/match_guided.h"
#include "rovio_sfm/matching/verify_pair.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// The filters that the matches of one pair pass, in order (§3.4–3.5).
struct PairOptions {
  MatchOptions match;
  float max_ratio = 0.9f;        // Lowe's, τ_u; 0.1 to 1
  float max_mean_factor = 2.0f;  // τ_κ of the percentile filter; 0.1 to 10
  VerifyPairOptions verify;
  bool use_guided = true;  // the second pass along the epipolar band, for general pairs
  GuidedOptions guided;

  bool IsValid(std::string* error) const;
};

// Matches an earlier frame with a later one: nearest descriptors, ratio, percentile, one-to-one,
// RANSAC on the essential matrix, guided pass. other_index is copied into the result; rng is drawn
// from by RANSAC alone.
PairMatches MatchPair(uint32_t other_index, const FrameFeatures& other,
                      const FrameFeatures& features, const Camera& camera,
                      const PairOptions& options, Rng& rng);

// The same for frames of two cameras: focal_px turns the thresholds into the plane z = 1.
PairMatches MatchPair(uint32_t other_index, const FrameFeatures& other,
                      const FrameFeatures& features, double focal_px, const PairOptions& options,
                      Rng& rng);

}  // namespace rovio_sfm
