#include "rovio_sfm/merging/try_loop.h"

#include <algorithm>

#include "rovio_sfm/merging/adjust_map.h"

namespace rovio_sfm {
namespace {

std::vector<FeatureLink> LinksOf(const Session& a, const Session& b, uint32_t query,
                                 const std::vector<OverlapPair>& pairs) {
  std::vector<FeatureLink> links;
  const size_t num_features_b = b.keyframe(query).points.size();
  for (const OverlapPair& pair : pairs) {
    const size_t num_features_a = a.keyframe(pair.other.index).points.size();
    for (const FeatureMatch& inlier : pair.inliers) {
      if (inlier.a >= num_features_a || inlier.b >= num_features_b) continue;
      links.push_back({{a.id(), pair.other.index, inlier.a}, {b.id(), query, inlier.b}});
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

}  // namespace

std::optional<OverlapTrial> TryLoop(const PlacedSession& a, const PlacedSession& b,
                                    const FrameId& query, const std::vector<OverlapPair>& pairs,
                                    const MapOptions& options) {
  OverlapTrial trial;
  trial.links = LinksOf(*a.session, *b.session, query.index, pairs);
  const LinkStatistics statistics = MeasureLinks({a, b}, trial.links);
  if (statistics.num_links < static_cast<uint32_t>(options.resect.min_inliers) ||
      statistics.median_error_px > options.merge.max_gap_px) {
    return std::nullopt;
  }
  MergeReport& report = trial.report;
  report.kind = MergeKind::kLoop;
  report.verdict = MergeVerdict::kAccepted;
  report.reason = "agrees with the map";
  report.query = query;
  report.other = pairs.front().other;
  report.query_session = b.session->id();
  report.other_session = a.session->id();
  report.num_candidates = static_cast<uint32_t>(pairs.size());
  report.num_matches = static_cast<uint32_t>(trial.links.size());
  report.num_inliers = statistics.num_links;
  report.num_links = static_cast<uint32_t>(trial.links.size());
  report.query_from_other = Inverse(b.map_from_session) * a.map_from_session;
  report.error_before_px = statistics.median_error_px;
  return trial;
}

}  // namespace rovio_sfm
