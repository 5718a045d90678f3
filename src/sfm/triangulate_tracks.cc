#include "rovio_sfm/sfm/triangulate_tracks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxViews = 24;  // a longer track is triangulated from this many, evenly spread
constexpr size_t kMaxPairs = 12;  // hypotheses tried per point

struct ViewPair {
  uint32_t a = 0, b = 0;
  double angle = 0.0;  // between the two rays
};

Eigen::Vector3d Ray(const PointView& view) {
  return view.cam_from_map.rotation.conjugate() * view.x_normalized.homogeneous().normalized();
}

std::vector<ViewPair> WidestPairs(const std::vector<PointView>& views) {
  std::vector<Eigen::Vector3d> rays;
  for (const PointView& view : views) rays.push_back(Ray(view));
  std::vector<ViewPair> pairs;
  for (uint32_t a = 0; a < views.size(); ++a) {
    for (uint32_t b = a + 1; b < views.size(); ++b) {
      pairs.push_back({a, b, std::atan2(rays[a].cross(rays[b]).norm(), rays[a].dot(rays[b]))});
    }
  }
  const size_t count = std::min(kMaxPairs, pairs.size());
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const ViewPair& p, const ViewPair& q) { return p.angle > q.angle; });
  pairs.resize(count);
  return pairs;
}

std::vector<uint32_t> Agreeing(const std::vector<PointView>& views, const Eigen::Vector3d& point,
                               double max_error_sigmas) {
  std::vector<uint32_t> agreeing;
  for (uint32_t i = 0; i < views.size(); ++i) {
    const auto error = ReprojectionError(views[i].cam_from_map, views[i].x_normalized, point);
    if (error && *error <= max_error_sigmas * views[i].sigma) agreeing.push_back(i);
  }
  return agreeing;
}

std::optional<Eigen::Vector3d> Fit(const std::vector<PointView>& views,
                                   const std::vector<uint32_t>& chosen) {
  std::vector<Rigid3> cams_from_map;
  std::vector<Eigen::Vector2d> x_normalized;
  for (const uint32_t i : chosen) {
    cams_from_map.push_back(views[i].cam_from_map);
    x_normalized.push_back(views[i].x_normalized);
  }
  const auto linear = TriangulateLinear(cams_from_map, x_normalized);
  if (!linear) return std::nullopt;
  return RefinePoint(cams_from_map, x_normalized, *linear);
}

double WidestAngle(const std::vector<PointView>& views, const TriangulatedPoint& point) {
  double widest = 0.0;
  for (const uint32_t i : point.inliers) {
    for (const uint32_t j : point.inliers) {
      if (j <= i) continue;
      widest = std::max(widest, ParallaxAngle(OriginInA(views[i].cam_from_map),
                                              OriginInA(views[j].cam_from_map), point.position));
    }
  }
  return widest;
}

std::vector<Observation> UsableMembers(const Session& session, const Track& track) {
  std::vector<Observation> usable;
  for (const Observation& member : track.members) {
    if (!session.keyframe(member.frame).weak) usable.push_back(member);
  }
  if (usable.size() <= kMaxViews) return usable;
  std::vector<Observation> spread;
  for (size_t i = 0; i < kMaxViews; ++i) {
    spread.push_back(usable[i * (usable.size() - 1) / (kMaxViews - 1)]);
  }
  return spread;
}

PointView ViewOf(const Session& session, const Observation& observation) {
  const Keyframe& frame = session.keyframe(observation.frame);
  return {frame.cam_from_session, frame.points[observation.feature],
          frame.sigmas[observation.feature]};
}

bool CreateLandmark(TrackId id, const Track& track, const LandmarkLimits& limits,
                    Session* session) {
  const std::vector<Observation> members = UsableMembers(*session, track);
  if (members.size() < 2) return false;
  std::vector<PointView> views;
  for (const Observation& member : members) views.push_back(ViewOf(*session, member));
  const auto point = TriangulatePoint(views, limits);
  if (!point) return false;
  std::vector<Observation> observations;
  for (const uint32_t i : point->inliers) observations.push_back(members[i]);
  const Observation& first = observations.front();
  const Rgb color = session->keyframe(first.frame).colors[first.feature];
  session->AddLandmark(id, point->position, color, observations);
  return true;
}

std::vector<Observation> UnobservedMembers(const Track& track, const Landmark& landmark) {
  std::vector<Observation> unobserved;
  std::set_difference(track.members.begin(), track.members.end(), landmark.observations.begin(),
                      landmark.observations.end(), std::back_inserter(unobserved));
  return unobserved;
}

uint32_t CompleteLandmark(TrackId id, double max_error_sigmas, Session* session) {
  const Landmark& landmark = session->landmarks().at(id);
  std::vector<Observation> missing;
  for (const Observation& member : UnobservedMembers(session->tracks().at(id), landmark)) {
    const Keyframe& frame = session->keyframe(member.frame);
    if (frame.weak) continue;
    const auto error =
        ReprojectionError(frame.cam_from_session, frame.points[member.feature], landmark.position);
    if (error && *error <= max_error_sigmas * frame.sigmas[member.feature]) {
      missing.push_back(member);
    }
  }
  for (const Observation& observation : missing) session->AddObservation(id, observation);
  return static_cast<uint32_t>(missing.size());
}

}  // namespace

std::optional<TriangulatedPoint> TriangulatePoint(const std::vector<PointView>& views,
                                                  const LandmarkLimits& limits) {
  TriangulatedPoint best;
  for (const ViewPair& pair : WidestPairs(views)) {
    if (pair.angle < limits.min_parallax_rad) break;
    const auto point = Fit(views, {pair.a, pair.b});
    if (!point) continue;
    std::vector<uint32_t> inliers = Agreeing(views, *point, limits.max_error_sigmas);
    if (inliers.size() <= best.inliers.size()) continue;
    best = {*point, std::move(inliers)};
    if (best.inliers.size() == views.size()) break;
  }
  if (best.inliers.size() < 2) return std::nullopt;
  const auto refined = Fit(views, best.inliers);
  if (!refined) return std::nullopt;
  best.position = *refined;
  best.inliers = Agreeing(views, *refined, limits.max_error_sigmas);
  if (best.inliers.size() < 2) return std::nullopt;
  if (WidestAngle(views, best) < limits.min_parallax_rad) return std::nullopt;
  return best;
}

uint32_t CompleteLandmarks(uint32_t frame, double max_error_sigmas, Session* session) {
  uint32_t num_completed = 0;
  for (const TrackId id : session->keyframe(frame).tracks) {
    if (id == 0 || session->landmarks().count(id) == 0) continue;
    num_completed += CompleteLandmark(id, max_error_sigmas, session);
  }
  return num_completed;
}

TriangulateReport TriangulateTracks(uint32_t frame, const LandmarkLimits& limits,
                                    Session* session) {
  TriangulateReport report;
  for (const TrackId id : session->keyframe(frame).tracks) {
    if (id == 0 || session->landmarks().count(id) == 1) continue;
    const Track& track = session->tracks().at(id);
    if (track.members.size() < 2) continue;
    if (CreateLandmark(id, track, limits, session)) ++report.num_created;
  }
  report.num_completed = CompleteLandmarks(frame, limits.max_error_sigmas, session);
  return report;
}

}  // namespace rovio_sfm
