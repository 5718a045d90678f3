#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/matching/match_pair.h"
#include "rovio_sfm/sfm/odometry_gate.h"

namespace rovio_sfm {

// How far back a keyframe is matched (§3.4.1).
struct RecursionOptions {
  int min_matches = 30;  // τ_m: with fewer verified matches a pair ends the recursion; 5 to 10000
  int max_frames = 8;    // τ_l: keyframes tried; 1 to 100
  int max_misses = 1;    // pairs below τ_m that are passed over first; 0 to 10
  OdometryGateOptions odometry_gate;

  bool IsValid(std::string* error) const;
};

// A keyframe that later ones are matched with.
struct RecentKeyframe {
  uint32_t index = 0;  // FrameId::index
  std::shared_ptr<const FrameFeatures> features;
  std::optional<Rigid3> odom_from_camera = std::nullopt;  // metres; none without odometry
};

// Matches a new keyframe with recent ones (oldest first), nearest first, until fewer than τ_m
// verified matches remain or τ_l frames were tried. Every pair tried is returned, with its counts;
// pairs below τ_m have the verdict kFailed and no inliers. Randomness depends on the seed and the
// two indices alone.
std::vector<PairMatches> MatchRecursively(const std::deque<RecentKeyframe>& recent,
                                          const RecentKeyframe& keyframe, const Camera& camera,
                                          const PairOptions& pair_options,
                                          const RecursionOptions& options, uint64_t seed);

}  // namespace rovio_sfm
