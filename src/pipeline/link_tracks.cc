#include "rovio_sfm/pipeline/link_tracks.h"

#include <utility>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

bool AllViewsAgree(const Session& session, const Landmark& landmark,
                   const Eigen::Vector3d& position, double max_error_sigmas) {
  for (const Observation& observation : landmark.observations) {
    const Keyframe& frame = session.keyframe(observation.frame);
    const auto error =
        ReprojectionError(frame.cam_from_session, frame.points[observation.feature], position);
    if (!error || *error > max_error_sigmas * frame.sigmas[observation.feature]) return false;
  }
  return true;
}

enum class LinkResult { kUnited, kRefusedF1, kRefusedF2 };

LinkResult Link(const TrackLink& link, double max_error_sigmas, Session* session) {
  if (session->RootOf(link.a) == session->RootOf(link.b)) return LinkResult::kUnited;
  if (session->HasMembersInOneFrame(link.a, link.b)) return LinkResult::kRefusedF1;
  if (session->UniteTracks(link.a, link.b)) return LinkResult::kUnited;
  return TryUniteLandmarks(link.a, link.b, max_error_sigmas, session) ? LinkResult::kUnited
                                                                      : LinkResult::kRefusedF2;
}

}  // namespace

bool TryUniteLandmarks(TrackId a, TrackId b, double max_error_sigmas, Session* session) {
  const Landmark* first = session->FindLandmark(a);
  const Landmark* second = session->FindLandmark(b);
  if (first == nullptr || second == nullptr || first == second) return false;
  if (session->HasMembersInOneFrame(a, b)) return false;
  const auto weight_a = static_cast<double>(first->observations.size() - 1);
  const auto weight_b = static_cast<double>(second->observations.size() - 1);
  const Eigen::Vector3d united =
      (weight_a * first->position + weight_b * second->position) / (weight_a + weight_b);
  if (!AllViewsAgree(*session, *first, united, max_error_sigmas) ||
      !AllViewsAgree(*session, *second, united, max_error_sigmas)) {
    return false;
  }
  return session->UniteLandmarks(a, b, united);
}

LinkReport LinkTracks(double max_error_sigmas, std::vector<TrackLink>* pending, Session* session) {
  LinkReport report;
  std::vector<TrackLink> retry;
  for (const TrackLink& link : *pending) {
    switch (Link(link, max_error_sigmas, session)) {
      case LinkResult::kUnited:
        ++report.num_united;
        break;
      case LinkResult::kRefusedF1:
        ++report.num_refused_f1;
        break;
      case LinkResult::kRefusedF2:
        retry.push_back(link);
        break;
    }
  }
  *pending = std::move(retry);
  return report;
}

}  // namespace rovio_sfm
