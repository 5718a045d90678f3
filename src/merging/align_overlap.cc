#include "rovio_sfm/merging/align_overlap.h"

#include <cmath>
#include <map>
#include <utility>

#include "rovio_sfm/mapping/register_frame.h"

namespace rovio_sfm {
namespace {

std::vector<CrossMatch> MatchesOf(const Session& a, const Session& b, uint32_t query,
                                  const std::vector<OverlapPair>& pairs) {
  std::vector<CrossMatch> matches;
  for (const OverlapPair& pair : pairs) {
    const std::vector<CrossMatch> found =
        FindCrossMatches(a, b, pair.other, {b.drive(), query}, pair.inliers);
    matches.insert(matches.end(), found.begin(), found.end());
  }
  return matches;
}

// The query camera among the landmarks of session a.
std::optional<Registration> ResectQuery(const std::vector<CrossMatch>& matches,
                                        const MapOptions& options) {
  std::map<uint32_t, PoseObservation> seen;  // by feature: each once
  for (const CrossMatch& match : matches) {
    if (!match.a.landmark) continue;
    seen.try_emplace(
        match.b.observation.feature,
        PoseObservation{match.a.landmark->position, match.b.x_normalized, match.b.sigma});
  }
  std::vector<PoseObservation> observations;
  for (const auto& [feature, observation] : seen) observations.push_back(observation);
  return RegisterObservations(observations, observations.size(), options);
}

// What the odometry of both sessions says of their scales.
std::optional<ScalePrior> PriorOf(const Session& a, const Session& b) {
  if (!a.scale() || !b.scale()) return std::nullopt;
  return ScalePrior{a.scale()->metres_per_unit / b.scale()->metres_per_unit,
                    std::hypot(a.scale()->sigma_log, b.scale()->sigma_log)};
}

// From the query camera resected in a: by the depths of common landmarks, or by odometry.
AlignReport AlignByResection(const std::vector<CrossMatch>& matches, const Rigid3& query_from_a,
                             const Rigid3& query_from_b, const std::optional<ScalePrior>& prior,
                             const AlignOptions& options) {
  AlignReport report = AlignFromPose(matches, query_from_a, query_from_b, options);
  if (report.alignment || !prior) return report;
  report = RefineAlignment(matches, SimilarityFromCamera(query_from_a, query_from_b, prior->scale),
                           options, prior);
  if (report.alignment) report.alignment->by_resection = true;
  return report;
}

OverlapAlignment Conclude(const AlignReport& report, const std::vector<CrossMatch>& matches) {
  OverlapAlignment result;
  result.alignment = report.alignment;
  result.num_matches = report.num_matches;
  result.num_common = report.num_common;
  if (!report.alignment) {
    result.reason = std::string("no alignment: ") + ToString(report.refusal);
    return result;
  }
  for (const uint32_t i : report.alignment->inliers) result.inliers.push_back(matches[i]);
  return result;
}

Rng StreamOf(const MapOptions& options, uint32_t query) { return Rng(options.seed).Fork(query); }

}  // namespace

OverlapAlignment AlignOverlap(const Session& a, const Session& b, uint32_t query,
                              const std::vector<OverlapPair>& pairs, const MapOptions& options) {
  const std::vector<CrossMatch> matches = MatchesOf(a, b, query, pairs);
  Rng rng = StreamOf(options, query);
  const AlignReport report = AlignByPoints(matches, options.merge.align, rng);
  if (report.alignment) return Conclude(report, matches);
  const auto resection = ResectQuery(matches, options);
  if (!resection) return Conclude(report, matches);
  const Rigid3& query_from_b = b.keyframe(query).cam_from_session;
  const auto prior = PriorOf(a, b);
  OverlapAlignment result = Conclude(AlignByResection(matches, resection->cam_from_session,
                                                      query_from_b, prior, options.merge.align),
                                     matches);
  result.needs_scale = !result.alignment && !prior;
  return result;
}

OverlapAlignment AlignLinks(const Session& a, const Session& b,
                            const std::vector<FeatureLink>& links, const Sim3& b_from_a,
                            const MapOptions& options) {
  std::vector<CrossMatch> matches;
  for (const FeatureLink& link : links) {
    const std::vector<CrossMatch> found =
        FindCrossMatches(a, b, {a.drive(), link.a.frame}, {b.drive(), link.b.frame},
                         {{link.a.feature, link.b.feature}});
    matches.insert(matches.end(), found.begin(), found.end());
  }
  AlignReport report = RefineAlignment(matches, b_from_a, options.merge.align);
  if (!report.alignment) {
    report = RefineAlignment(matches, b_from_a, options.merge.align, PriorOf(a, b));
  }
  return Conclude(report, matches);
}

}  // namespace rovio_sfm
