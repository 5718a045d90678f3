#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/matching/match_descriptors.h"
#include "rovio_sfm/matching/match_guided.h"
#include "rovio_sfm/matching/verify_pair.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/option_table.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// The filters that the matches of one pair pass, in order (§3.4–3.5).
struct PairOptions {
  MatchOptions match;
  float max_ratio = 0.9f;
  float max_mean_factor = 2.0f;
  VerifyPairOptions verify;
  bool use_guided = true;
  GuidedOptions guided;

  void DescribeOptions(OptionTable& table) {
    table.AddGroup("match", match, "");
    table.AddLiveNumber("max_ratio", max_ratio, 0.1, 1.0, "Lowe's, τ_u");
    table.AddLiveNumber("max_mean_factor", max_mean_factor, 0.1, 10.0, "percentile filter, τ_κ");
    table.AddGroup("verify", verify, "RANSAC on the essential matrix");
    table.AddLiveFlag("use_guided", use_guided, "second pass, where known matches' depths tell");
    table.AddGroup("guided", guided, "");
  }
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

// From matches that other frames tell (ratios theirs, distances anew) instead of a search: the
// percentile filter and those after it.
PairMatches MatchExpected(uint32_t other_index, const FrameFeatures& other,
                          const FrameFeatures& features, std::vector<FeatureMatch> expected,
                          const Camera& camera, const PairOptions& options, Rng& rng);

}  // namespace rovio_sfm
