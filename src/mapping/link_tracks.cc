#include "rovio_sfm/mapping/link_tracks.h"

#include <utility>

namespace rovio_sfm {
namespace {

LandmarkViews ViewsOf(const Session& session, const Landmark& landmark) {
  LandmarkViews views;
  views.position = landmark.position;
  for (const Observation& observation : landmark.observations) {
    const Keyframe& frame = session.keyframe(observation.frame);
    views.cams_from_map.push_back(frame.cam_from_session);
    views.x_normalized.push_back(frame.points[observation.feature]);
    views.sigmas.push_back(frame.sigmas[observation.feature]);
  }
  return views;
}

enum class LinkResult { kUnited, kRefusedF1, kRefusedF2 };

LinkResult Link(const TrackLink& link, const FilterF2Options& f2, Session* session) {
  if (session->RootOf(link.a) == session->RootOf(link.b)) return LinkResult::kUnited;
  if (session->HasMembersInOneFrame(link.a, link.b)) return LinkResult::kRefusedF1;
  if (session->UniteTracks(link.a, link.b)) return LinkResult::kUnited;
  return TryUniteLandmarks(link.a, link.b, f2, session) ? LinkResult::kUnited
                                                        : LinkResult::kRefusedF2;
}

}  // namespace

bool TryUniteLandmarks(TrackId a, TrackId b, const FilterF2Options& f2, Session* session) {
  const Landmark* first = session->FindLandmark(a);
  const Landmark* second = session->FindLandmark(b);
  if (first == nullptr || second == nullptr || first == second) return false;
  if (session->HasMembersInOneFrame(a, b)) return false;
  const LandmarkViews views_a = ViewsOf(*session, *first), views_b = ViewsOf(*session, *second);
  if (!PassesFilterF2(views_a, views_b, f2)) return false;
  return session->UniteLandmarks(a, b, UnitedPosition(views_a, views_b));
}

LinkReport LinkTracks(const FilterF2Options& f2, std::vector<TrackLink>* pending,
                      Session* session) {
  LinkReport report;
  std::vector<TrackLink> retry;
  for (const TrackLink& link : *pending) {
    switch (Link(link, f2, session)) {
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
