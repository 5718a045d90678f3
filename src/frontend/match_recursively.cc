#include "rovio_sfm/frontend/match_recursively.h"

#include <unordered_map>
#include <utility>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr double kMinAgreedShare = 0.5;  // of expected matches, by geometry

Rng PairRng(uint64_t seed, uint32_t index, uint32_t other_index) {
  return Rng(seed).Fork((uint64_t{index} << 32) | other_index);
}

bool FitsOdometry(const PairMatches& pair, const RecentKeyframe& other,
                  const RecentKeyframe& keyframe, const OdometryGateOptions& options) {
  if (!other.odom_from_camera || !keyframe.odom_from_camera) return true;
  return PassesOdometryGate(pair, *other.odom_from_camera, *keyframe.odom_from_camera, options);
}

std::unordered_map<TrackId, uint32_t> FeatureOfTrack(const RecentKeyframe& keyframe) {
  std::unordered_map<TrackId, uint32_t> features;  // look-up only
  for (uint32_t i = 0; i < keyframe.tracks.size(); ++i) {
    if (keyframe.tracks[i] != 0) features[keyframe.tracks[i]] = i;
  }
  return features;
}

// A feature that matches one of a track in a nearer keyframe is expected to match that of the track
// in the other. pairs: with the newest of the recent ones, from the last on.
std::vector<FeatureMatch> ExpectMatches(const std::deque<RecentKeyframe>& recent,
                                        const std::vector<PairMatches>& pairs,
                                        const RecentKeyframe& other,
                                        const RecentKeyframe& keyframe) {
  if (pairs.empty()) return {};
  const std::unordered_map<TrackId, uint32_t> feature_of = FeatureOfTrack(other);
  std::vector<bool> is_told(keyframe.features->keypoints.size(), false);
  std::vector<FeatureMatch> expected;
  auto nearer = recent.rbegin();
  for (const PairMatches& pair : pairs) {
    const std::vector<TrackId>& tracks = (nearer++)->tracks;
    for (const FeatureMatch& match : pair.inliers) {
      if (is_told[match.b] || match.a >= tracks.size()) continue;
      const auto feature = feature_of.find(tracks[match.a]);
      if (feature == feature_of.end()) continue;
      is_told[match.b] = true;
      expected.push_back({feature->second, match.b, match.distance, match.ratio});
    }
  }
  return expected;
}

// Whether geometry says of a pair what its matches were expected to.
bool IsAsExpected(const PairMatches& pair, size_t num_expected, size_t min_expected) {
  return pair.verdict == PairVerdict::kGeneral && pair.counts.ransac >= min_expected &&
         pair.counts.ransac >= kMinAgreedShare * static_cast<double>(num_expected);
}

// By the matches that are expected, where they are enough and hold; else by a search through all.
PairMatches MatchOne(const RecentKeyframe& other, const RecentKeyframe& keyframe,
                     const std::vector<FeatureMatch>& expected, const Camera& camera,
                     const PairOptions& options, size_t min_expected, const Rng& rng) {
  if (expected.size() >= min_expected) {
    Rng own = rng;
    PairMatches pair = MatchExpected(other.index, *other.features, *keyframe.features, expected,
                                     camera, options, own);
    if (IsAsExpected(pair, expected.size(), min_expected)) return pair;
  }
  Rng own = rng;
  return MatchPair(other.index, *other.features, *keyframe.features, camera, options, own);
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
    pairs.push_back(MatchOne(*other, keyframe, ExpectMatches(recent, pairs, *other, keyframe),
                             camera, pair_options, static_cast<size_t>(options.min_expected),
                             PairRng(seed, keyframe.index, other->index)));
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
