#include "rovio_sfm/frontend/match_recursively.h"

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

Rng PairRng(uint64_t seed, uint32_t index, uint32_t other_index) {
  return Rng(seed).Fork((uint64_t{index} << 32) | other_index);
}

bool FitsOdometry(const PairMatches& pair, const RecentKeyframe& other,
                  const RecentKeyframe& keyframe, const OdometryGateOptions& options) {
  if (!other.odom_from_camera || !keyframe.odom_from_camera) return true;
  return PassesOdometryGate(pair, *other.odom_from_camera, *keyframe.odom_from_camera, options);
}

}  // namespace

std::vector<PairMatches> MatchRecursively(const std::deque<RecentKeyframe>& recent,
                                          const RecentKeyframe& keyframe, const Camera& camera,
                                          const PairOptions& pair_options,
                                          const RecursionOptions& options, uint64_t seed) {
  std::vector<PairMatches> pairs;
  int num_misses = 0;
  for (auto other = recent.rbegin(); other != recent.rend(); ++other) {
    if (pairs.size() == static_cast<size_t>(options.max_frames)) break;
    if (num_misses > options.max_misses) break;
    Rng rng = PairRng(seed, keyframe.index, other->index);
    pairs.push_back(
        MatchPair(other->index, *other->features, *keyframe.features, camera, pair_options, rng));
    if (pairs.back().inliers.size() >= static_cast<size_t>(options.min_matches) &&
        FitsOdometry(pairs.back(), *other, keyframe, options.odometry_gate)) {
      continue;
    }
    pairs.back().verdict = PairVerdict::kFailed;
    pairs.back().inliers.clear();
    ++num_misses;
  }
  return pairs;
}

}  // namespace rovio_sfm
