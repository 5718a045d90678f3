#include "rovio_sfm/merging/align_overlap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr double kSigmaOfScale = 0.1;  // of its log, by few frames or landmarks

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

// A frame of session a with its pose in both sessions.
struct FrameInBoth {
  Rigid3 cam_from_a, cam_from_b;
  uint32_t num_inliers = 0;
};

// The frames of a that match landmarks of b, resected there, most inliers first.
std::vector<FrameInBoth> ResectOthers(const Session& a, const std::vector<CrossMatch>& matches,
                                      const MapOptions& options) {
  std::map<uint32_t, std::vector<PoseObservation>> observations;  // by frame of a
  for (const CrossMatch& match : matches) {
    if (!match.b.landmark) continue;
    observations[match.a.observation.frame].push_back(
        {match.b.landmark->position, match.a.x_normalized, match.a.sigma});
  }
  std::vector<FrameInBoth> frames;
  for (const auto& [frame, of_frame] : observations) {
    const auto registration = RegisterObservations(of_frame, of_frame.size(), options);
    if (!registration) continue;
    frames.push_back({a.keyframe(frame).cam_from_session, registration->cam_from_session,
                      registration->num_inliers});
  }
  std::stable_sort(frames.begin(), frames.end(), [](const FrameInBoth& x, const FrameInBoth& y) {
    return x.num_inliers > y.num_inliers;
  });
  return frames;
}

// How long a's unit is in b, by each landmark of a that the query shows: where on its ray it lies.
std::vector<double> LogScalesOfLandmarks(const std::vector<CrossMatch>& matches,
                                         const FrameInBoth& frame, const Rigid3& query_from_b) {
  const Rigid3 query_from_cam = query_from_b * Inverse(frame.cam_from_b);
  std::vector<double> log_scales;
  for (const CrossMatch& match : matches) {
    if (!match.a.landmark) continue;
    const Eigen::Vector3d ray = match.b.x_normalized.homogeneous();
    const Eigen::Vector3d x_in_cam = frame.cam_from_a * match.a.landmark->position;
    const Eigen::Vector3d turned = ray.cross(query_from_cam.rotation * x_in_cam);
    const double scale = -turned.dot(ray.cross(query_from_cam.translation)) / turned.squaredNorm();
    if (scale > 0.0 && std::isfinite(scale)) log_scales.push_back(std::log(scale));
  }
  return log_scales;
}

// The scale by the distance of two frames posed in both sessions, or by a's landmarks in the query.
std::optional<double> ScaleOf(const std::vector<FrameInBoth>& frames,
                              const std::vector<CrossMatch>& matches, const Rigid3& query_from_b,
                              const AlignOptions& options) {
  if (frames.size() >= 2) {
    const double in_a = (OriginInA(frames[0].cam_from_a) - OriginInA(frames[1].cam_from_a)).norm();
    const double in_b = (OriginInA(frames[0].cam_from_b) - OriginInA(frames[1].cam_from_b)).norm();
    if (in_a > 0.0 && in_b > 0.0) return in_b / in_a;
  }
  const auto log_scales = LogScalesOfLandmarks(matches, frames[0], query_from_b);
  if (log_scales.size() < static_cast<size_t>(options.min_common)) return std::nullopt;
  return std::exp(Median(log_scales));
}

// From frames of a that b's landmarks pose in b too.
std::optional<AlignReport> AlignByFramesInBoth(const Session& a, const Rigid3& query_from_b,
                                               const std::vector<CrossMatch>& matches,
                                               const MapOptions& options) {
  const std::vector<FrameInBoth> frames = ResectOthers(a, matches, options);
  if (frames.empty()) return std::nullopt;
  const auto scale = ScaleOf(frames, matches, query_from_b, options.merge.align);
  if (!scale) return std::nullopt;
  AlignReport report = RefineAlignment(
      matches, SimilarityFromCamera(frames[0].cam_from_a, frames[0].cam_from_b, *scale),
      options.merge.align, ScalePrior{*scale, kSigmaOfScale});
  if (!report.alignment) return std::nullopt;
  report.alignment->by_resection = true;
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
  const auto prior = PriorOf(a, b);
  OverlapAlignment result = Conclude(report, matches);
  if (resection) {
    const Rigid3& query_from_b = b.keyframe(query).cam_from_session;
    result = Conclude(AlignByResection(matches, resection->cam_from_session, query_from_b, prior,
                                       options.merge.align),
                      matches);
  }
  if (!result.alignment) {
    const auto by_frames =
        AlignByFramesInBoth(a, b.keyframe(query).cam_from_session, matches, options);
    if (by_frames) return Conclude(*by_frames, matches);
  }
  result.needs_scale = resection && !result.alignment && !prior;
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
