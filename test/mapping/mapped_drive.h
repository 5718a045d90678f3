#pragma once

#include <deque>

#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/scene/memory_frame_store.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session.h"
#include "synthetic/synthetic_drive.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {

// The drive's first keyframes at their true poses; no landmarks. All of them by default.
inline Session PosedDrive(const SyntheticDrive& drive, size_t num_events = SIZE_MAX) {
  Session session({1}, drive.events[0].id.drive, drive.world.camera);
  for (size_t i = 0; i < std::min(num_events, drive.events.size()); ++i) {
    const FrameEvent& event = drive.events[i];
    if (event.kind == FrameKind::kLight) continue;
    session.AddKeyframe(event.id.index, MakeKeyframe(event, drive.world.cams_from_map[i], {}));
  }
  return session;
}

// The point that an observation shows.
inline uint32_t PointOf(const SyntheticDrive& drive, const Observation& observation) {
  return drive.world.views[observation.frame][observation.feature].point;
}

// The same with the true landmark of every track with two members and more.
inline Session MappedDrive(const SyntheticDrive& drive, size_t num_events = SIZE_MAX) {
  Session session = PosedDrive(drive, num_events);
  for (const auto& [id, track] : session.tracks()) {
    if (track.members.size() < 2) continue;
    session.AddLandmark(id, drive.world.points[PointOf(drive, track.members[0])], {},
                        track.members);
  }
  return session;
}

// The features of the drive's keyframes.
inline MemoryFrameStore StoreOf(const SyntheticDrive& drive) {
  MemoryFrameStore store;
  for (const FrameEvent& event : drive.events) {
    if (event.kind == FrameKind::kKeyframe) store.Put(event.id, event.features);
  }
  return store;
}

// What two keyframes of the drive see of the same points.
inline PlaceMatch TruePlace(const SyntheticDrive& drive, uint32_t query, uint32_t other) {
  const OverlapPair pair{
      drive.events[other].id, PairVerdict::kGeneral, {}, TrueMatches(drive.world, other, query)};
  return {drive.events[query].id, 1.0, 0.0, {pair}};
}

// Moves keyframes (but the first) and landmarks from where they are.
inline void Disturb(double sigma_rad, double sigma, Session* session) {
  Rng rng(9);
  std::vector<uint32_t> frames;
  std::vector<TrackId> tracks;
  for (const auto& [index, frame] : session->keyframes()) frames.push_back(index);
  for (const auto& [id, landmark] : session->landmarks()) tracks.push_back(id);
  for (size_t i = 1; i < frames.size(); ++i) {
    const Rigid3 pose = session->keyframe(frames[i]).cam_from_session;
    session->SetPose(frames[i], PerturbPose(pose, sigma_rad, sigma, rng));
  }
  for (const TrackId id : tracks) {
    const Eigen::Vector3d position = session->landmarks().at(id).position;
    session->SetPosition(id, position + PerturbPose({}, 0.0, sigma, rng).translation);
  }
}

inline std::string BytesOf(const Session& session) {
  MapSnapshot snapshot;
  snapshot.sessions = {session.Snapshot()};
  return BytesOf(snapshot);
}

}  // namespace rovio_sfm
