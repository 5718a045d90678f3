#include "rovio_sfm/merging/undo_merge.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/mapping/register_frame.h"

namespace rovio_sfm {
namespace {

// Where the session as it is now lies in what it was.
Sim3 BeforeFromNow(const Session& before, const Session& now) {
  std::vector<Eigen::Vector3d> points_now, points_before;
  for (const auto& [id, landmark] : before.landmarks()) {
    const auto it = now.landmarks().find(id);
    if (it == now.landmarks().end()) continue;
    points_now.push_back(it->second.position);
    points_before.push_back(landmark.position);
  }
  for (const auto& [index, frame] : before.keyframes()) {
    const auto it = now.keyframes().find(index);
    if (it == now.keyframes().end()) continue;
    points_now.push_back(OriginInA(it->second.cam_from_session));
    points_before.push_back(OriginInA(frame.cam_from_session));
  }
  return AlignPoints(points_now, points_before).value_or(Sim3{});
}

// The keyframes that came since, at the same place relative to the others; returns their indices.
std::vector<uint32_t> AddLaterKeyframes(const Session& now, const Sim3& before_from_now,
                                        Session* restored) {
  std::vector<uint32_t> added;
  for (const auto& [index, frame] : now.keyframes()) {
    if (restored->keyframes().count(index) != 0) continue;
    Keyframe moved = frame;
    moved.cam_from_session = TransformCamera(before_from_now, frame.cam_from_session);
    restored->AddKeyframe(index, std::move(moved));
    added.push_back(index);
  }
  return added;
}

// The observations that only later frames have, by the track that they are in now.
std::map<TrackId, std::vector<Observation>> LaterObservations(const Landmark& landmark,
                                                              const std::set<uint32_t>& later,
                                                              const Session& restored) {
  std::map<TrackId, std::vector<Observation>> observations;
  for (const Observation& observation : landmark.observations) {
    if (later.count(observation.frame) == 0) continue;
    const TrackId track = restored.keyframe(observation.frame).tracks[observation.feature];
    if (track != 0) observations[track].push_back(observation);
  }
  return observations;
}

void AddLaterLandmarks(const Session& now, const std::vector<uint32_t>& later,
                       const Sim3& before_from_now, Session* restored) {
  const std::set<uint32_t> frames(later.begin(), later.end());
  for (const auto& [id, landmark] : now.landmarks()) {
    for (const auto& [track, observations] : LaterObservations(landmark, frames, *restored)) {
      if (restored->landmarks().count(track) != 0) {
        for (const Observation& o : observations) restored->AddObservation(track, o);
      } else if (observations.size() >= 2) {
        restored->AddLandmark(track, before_from_now * landmark.position, landmark.color,
                              observations);
      }
    }
  }
}

}  // namespace

void RestoreSession(const Session& before, const MapperOptions& options, Session* session) {
  Session restored = before;
  const Sim3 before_from_now = BeforeFromNow(before, *session);
  const std::vector<uint32_t> later = AddLaterKeyframes(*session, before_from_now, &restored);
  AddLaterLandmarks(*session, later, before_from_now, &restored);
  for (const uint32_t index : later) {
    if (restored.keyframe(index).weak) continue;
    const auto registration = RegisterAgain(index, options, restored);
    if (registration) restored.SetPose(index, registration->cam_from_session);
  }
  for (const auto& [index, frame] : session->light_frames()) {
    const bool is_new = restored.light_frames().count(index) == 0;
    if (is_new && restored.keyframes().count(frame.reference) != 0) {
      restored.AddLightFrame(index, frame);
    }
  }
  restored.set_state(session->state());
  restored.set_odometry_delay(session->odometry_delay());
  *session = std::move(restored);
}

}  // namespace rovio_sfm
