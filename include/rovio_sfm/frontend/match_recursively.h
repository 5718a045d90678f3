#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/matching/match_pair.h"
#include "rovio_sfm/sfm/odometry_gate.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// How far back a keyframe is matched (§3.4.1).
struct RecursionOptions {
  int min_matches = 30;
  int max_frames = 8;
  int max_misses = 7;
  int min_expected = 100;
  OdometryGateOptions odometry_gate;

  void DescribeOptions(OptionTable& table) {
    table.AddLiveNumber("min_matches", min_matches, 5, 10000, "τ_m: a pair with fewer ends it");
    table.AddLiveNumber("max_frames", max_frames, 1, 100, "τ_l: keyframes tried");
    table.AddLiveNumber("max_misses", max_misses, 0, 10, "pairs below τ_m passed over first");
    table.AddLiveNumber("min_expected", min_expected, 20, 1000000,
                        "matches that nearer pairs tell; fewer: all features are searched");
    table.AddGroup("odometry_gate", odometry_gate, "refuses what the wheels contradict (§3.5)");
  }
};

// A keyframe that later ones are matched with.
struct RecentKeyframe {
  uint32_t index = 0;  // FrameId::index
  std::shared_ptr<const FrameFeatures> features;
  std::optional<Rigid3> odom_from_camera = std::nullopt;  // metres; none without odometry
  std::vector<TrackId> tracks = {};                       // FrameEvent::tracks, once it has them
};

// Matches a new keyframe with recent ones (oldest first), nearest first, until fewer than τ_m
// verified matches remain or τ_l frames were tried. What tracks of nearer ones tell of a pair takes
// the place of a search through all features, where geometry agrees. Every pair tried is returned,
// with its counts; pairs below τ_m have the verdict kFailed and no inliers. Randomness depends on
// the seed and the two indices alone.
std::vector<PairMatches> MatchRecursively(const std::deque<RecentKeyframe>& recent,
                                          const RecentKeyframe& keyframe, const Camera& camera,
                                          const PairOptions& pair_options,
                                          const RecursionOptions& options, uint64_t seed);

}  // namespace rovio_sfm
