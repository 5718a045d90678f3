#include "rovio_sfm/matching/filter_matches.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <unordered_map>

namespace rovio_sfm {
namespace {

bool IsNearer(const FeatureMatch& x, const FeatureMatch& y) {
  return std::tie(x.distance, x.ratio, x.a, x.b) < std::tie(y.distance, y.ratio, y.a, y.b);
}

template <typename Predicate>
std::vector<FeatureMatch> KeepIf(const std::vector<FeatureMatch>& matches, Predicate keep) {
  std::vector<FeatureMatch> kept;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(kept), keep);
  return kept;
}

// The nearest match of each feature on one side.
std::unordered_map<uint32_t, FeatureMatch> NearestOf(const std::vector<FeatureMatch>& matches,
                                                     uint32_t FeatureMatch::*side) {
  std::unordered_map<uint32_t, FeatureMatch> nearest;
  for (const FeatureMatch& match : matches) {
    const auto [it, is_new] = nearest.emplace(match.*side, match);
    if (!is_new && IsNearer(match, it->second)) it->second = match;
  }
  return nearest;
}

}  // namespace

std::vector<FeatureMatch> FilterByRatio(const std::vector<FeatureMatch>& matches, float max_ratio) {
  return KeepIf(matches, [&](const FeatureMatch& match) { return match.ratio <= max_ratio; });
}

std::vector<FeatureMatch> FilterByMeanDistance(const std::vector<FeatureMatch>& matches,
                                               float max_factor) {
  double sum = 0.0;
  for (const FeatureMatch& match : matches) sum += match.distance;
  const double limit = max_factor * sum / static_cast<double>(std::max<size_t>(1, matches.size()));
  return KeepIf(matches, [&](const FeatureMatch& match) { return match.distance <= limit; });
}

std::vector<FeatureMatch> FilterOneToOne(const std::vector<FeatureMatch>& matches) {
  const auto of_a = NearestOf(matches, &FeatureMatch::a);
  const auto of_b = NearestOf(matches, &FeatureMatch::b);
  return KeepIf(matches, [&](const FeatureMatch& match) {
    const FeatureMatch &best_a = of_a.at(match.a), &best_b = of_b.at(match.b);
    return best_a.b == match.b && best_b.a == match.a;
  });
}

}  // namespace rovio_sfm
