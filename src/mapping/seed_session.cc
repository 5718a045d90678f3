#include "rovio_sfm/mapping/seed_session.h"

#include <map>
#include <optional>
#include <utility>

#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/mapping/stage_options.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {
namespace {

// The other session's landmarks, by feature of a held frame or by track of the held drive.
using Borrowed = std::map<uint64_t, Eigen::Vector3d>;

const FrameEvent* FindHeld(const std::deque<FrameEvent>& held, const FrameId& id) {
  for (const FrameEvent& event : held) {
    if (event.id == id) return &event;
  }
  return nullptr;
}

// The session that the matches show most of; null if none is mapped.
const Session* ChooseSession(const std::vector<PlaceMatch>& matches, const SessionTable& sessions) {
  std::map<SessionId, size_t> shared;
  for (const PlaceMatch& match : matches) {
    for (const OverlapPair& pair : match.pairs) {
      const Session* holder = sessions.FindHolder(pair.other);
      if (holder != nullptr) shared[holder->id()] += pair.inliers.size();
    }
  }
  const Session* best = nullptr;
  for (const auto& [id, count] : shared) {
    if (best == nullptr || count > shared.at(best->id())) best = sessions.Find(id);
  }
  return best;
}

Borrowed BorrowedBy(const PlaceMatch& match, const Session& other) {
  Borrowed borrowed;
  for (const OverlapPair& pair : match.pairs) {
    if (!(pair.other.drive == other.drive())) continue;
    for (const FeatureMatch& inlier : pair.inliers) {
      const Landmark* landmark = ObservedLandmark(other, {other.id(), pair.other.index, inlier.a});
      if (landmark != nullptr) borrowed.try_emplace(inlier.b, landmark->position);
    }
  }
  return borrowed;
}

std::optional<Rigid3> Resect(const FrameEvent& event, const Borrowed& by_feature,
                             const MapperOptions& options) {
  std::vector<PoseObservation> observations;
  for (const auto& [feature, position] : by_feature) {
    if (feature >= event.features->keypoints.size()) continue;
    observations.push_back(
        ObserveLandmark(event, static_cast<uint32_t>(feature), position, options));
  }
  const auto registration = RegisterObservations(observations, event.id.index, options);
  if (!registration) return std::nullopt;
  return registration->cam_from_session;
}

// What the tracks of the matched features carry to another held frame.
Borrowed CarriedTo(const FrameEvent& event, const Borrowed& by_track, const Session& session) {
  Borrowed by_feature;
  for (uint32_t i = 0; i < event.tracks.size(); ++i) {
    if (event.tracks[i] == 0) continue;
    const auto it = by_track.find(session.RootOf(event.tracks[i]));
    if (it != by_track.end()) by_feature.emplace(i, it->second);
  }
  return by_feature;
}

// The held frames that see enough of the other session, with their poses there.
std::map<uint32_t, Rigid3> PoseHeld(const std::deque<FrameEvent>& held,
                                    const std::vector<PlaceMatch>& matches, const Session& other,
                                    const MapperOptions& options, const Session& session) {
  std::map<uint32_t, Rigid3> poses;
  Borrowed by_track;
  for (const PlaceMatch& match : matches) {
    const FrameEvent* event = FindHeld(held, match.query);
    if (event == nullptr) continue;
    const Borrowed by_feature = BorrowedBy(match, other);
    const auto pose = Resect(*event, by_feature, options);
    if (!pose) continue;
    poses.emplace(event->id.index, *pose);
    for (const auto& [feature, position] : by_feature) {
      const TrackId track = event->tracks[feature];
      if (track != 0) by_track.try_emplace(session.RootOf(track), position);
    }
  }
  for (const FrameEvent& event : held) {
    if (poses.count(event.id.index) != 0) continue;
    const auto pose = Resect(event, CarriedTo(event, by_track, session), options);
    if (pose) poses.emplace(event.id.index, *pose);
  }
  return poses;
}

}  // namespace

bool SeedSession(const std::deque<FrameEvent>& held, const std::vector<PlaceMatch>& matches,
                 const SessionTable& sessions, const MapperOptions& options, Session* session) {
  const Session* other = ChooseSession(matches, sessions);
  if (other == nullptr) return false;
  const auto poses = PoseHeld(held, matches, *other, options, *session);
  if (poses.size() < 2) return false;
  const LandmarkLimits triangulate = TriangulationLimits(options);
  for (const FrameEvent& event : held) {
    const auto pose = poses.find(event.id.index);
    if (pose == poses.end()) continue;
    session->AddKeyframe(event.id.index, MakeKeyframe(event, pose->second, options));
    TriangulateTracks(event.id.index, triangulate, session);
  }
  if (session->landmarks().size() >= static_cast<size_t>(options.bootstrap.min_inliers) / 2) {
    return true;
  }
  for (const auto& [index, pose] : poses) session->RemoveKeyframe(index);
  return false;
}

}  // namespace rovio_sfm
