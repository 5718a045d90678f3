#include "rovio_sfm/sfm/session_bundle.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace rovio_sfm {
namespace {

using CountByFrame = std::unordered_map<uint32_t, uint32_t>;

// How often each other frame sees a landmark that one of `frames` sees.
CountByFrame CountShared(const Session& session, const std::vector<uint32_t>& frames) {
  std::unordered_set<TrackId> seen;
  CountByFrame shared;
  for (const uint32_t frame : frames) {
    const Keyframe& keyframe = session.keyframe(frame);
    for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
      if (!keyframe.observed[i] || !seen.insert(keyframe.tracks[i]).second) continue;
      for (const Observation& observation :
           session.landmarks().at(keyframe.tracks[i]).observations) {
        ++shared[observation.frame];
      }
    }
  }
  for (const uint32_t frame : frames) shared.erase(frame);
  return shared;
}

// Of equal counts the oldest frames.
std::vector<uint32_t> MostShared(const CountByFrame& shared, size_t max_count,
                                 uint32_t min_shared) {
  std::vector<std::pair<uint32_t, uint32_t>> ranked;  // (count, frame)
  for (const auto& [frame, count] : shared) {
    if (count >= min_shared) ranked.emplace_back(count, frame);
  }
  std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::vector<uint32_t> frames;
  for (size_t i = 0; i < std::min(max_count, ranked.size()); ++i) {
    frames.push_back(ranked[i].second);
  }
  return frames;
}

// Adds cameras and points as they are first needed.
class BundleBuilder {
 public:
  explicit BundleBuilder(const Session& session) : session_(session) {}

  // All at once: a whole session's observations take 100 MB, and grown by doubling twice that.
  void Reserve(size_t num_observations) { bundle_.problem.observations.reserve(num_observations); }

  void AddCamera(uint32_t frame, bool fixed) {
    const Keyframe& keyframe = session_.keyframe(frame);
    cameras_[frame] = {static_cast<uint32_t>(bundle_.frames.size()), &keyframe};
    bundle_.frames.push_back(frame);
    bundle_.problem.cameras.push_back({keyframe.cam_from_session, fixed});
  }

  void AddLandmark(TrackId id, const Landmark& landmark) {
    const auto point = static_cast<uint32_t>(bundle_.tracks.size());
    bool any = false;
    for (const Observation& observation : landmark.observations) {
      const auto found = cameras_.find(observation.frame);
      if (found == cameras_.end()) continue;
      const Keyframe& frame = *found->second.keyframe;
      if (!((frame.cam_from_session * landmark.position).z() > 1e-6)) continue;
      bundle_.problem.observations.push_back({found->second.number, point,
                                              frame.sigmas[observation.feature],
                                              frame.points[observation.feature]});
      any = true;
    }
    if (!any) return;
    bundle_.tracks.push_back(id);
    bundle_.problem.points.push_back(landmark.position);
  }

  SessionBundle Take() { return std::move(bundle_); }

 private:
  struct AddedCamera {
    uint32_t number = 0;  // in the bundle
    const Keyframe* keyframe = nullptr;
  };

  const Session& session_;
  SessionBundle bundle_;
  std::unordered_map<uint32_t, AddedCamera> cameras_;  // look-up only
};

// The newest frame of the map not after `frame`, else the oldest.
uint32_t ReferenceOf(const std::map<uint32_t, Rigid3>& frames, uint32_t frame) {
  auto it = frames.upper_bound(frame);
  if (it != frames.begin()) --it;
  return it->first;
}

}  // namespace

std::vector<uint32_t> CovisibleFrames(const Session& session, uint32_t frame, size_t max_count,
                                      uint32_t min_shared) {
  std::vector<uint32_t> frames = {frame};
  for (const uint32_t other : MostShared(CountShared(session, frames), max_count - 1, min_shared)) {
    frames.push_back(other);
  }
  return frames;
}

SessionBundle MakeLocalBundle(const Session& session, const std::vector<uint32_t>& free_frames,
                              size_t max_fixed) {
  BundleBuilder builder(session);
  std::set<TrackId> tracks;
  for (const uint32_t frame : free_frames) {
    builder.AddCamera(frame, false);
    const Keyframe& keyframe = session.keyframe(frame);
    for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
      if (keyframe.observed[i]) tracks.insert(keyframe.tracks[i]);
    }
  }
  for (const uint32_t frame : MostShared(CountShared(session, free_frames), max_fixed, 1)) {
    builder.AddCamera(frame, true);
  }
  for (const TrackId id : tracks) builder.AddLandmark(id, session.landmarks().at(id));
  return builder.Take();
}

SessionBundle MakeGlobalBundle(const Session& session) {
  BundleBuilder builder(session);
  for (const auto& [index, frame] : session.keyframes()) {
    if (!frame.weak) builder.AddCamera(index, false);
  }
  size_t num_observations = 0;
  for (const auto& [id, landmark] : session.landmarks()) {
    num_observations += landmark.observations.size();
  }
  builder.Reserve(num_observations);
  for (const auto& [id, landmark] : session.landmarks()) builder.AddLandmark(id, landmark);
  return builder.Take();
}

void ApplyBundle(const SessionBundle& bundle, bool move_others, Session* session) {
  std::map<uint32_t, Rigid3> corrections;  // new session from old session, by reference frame
  std::set<uint32_t> known_frames(bundle.frames.begin(), bundle.frames.end());
  for (size_t i = 0; i < bundle.frames.size(); ++i) {
    const uint32_t frame = bundle.frames[i];
    if (session->keyframes().count(frame) == 0) continue;
    const Rigid3& cam_from_new = bundle.problem.cameras[i].cam_from_map;
    corrections[frame] = Inverse(cam_from_new) * session->keyframe(frame).cam_from_session;
    session->SetPose(frame, cam_from_new);
  }
  const std::set<TrackId> known_tracks(bundle.tracks.begin(), bundle.tracks.end());
  for (size_t i = 0; i < bundle.tracks.size(); ++i) {
    if (session->landmarks().count(bundle.tracks[i]) == 0) continue;
    session->SetPosition(bundle.tracks[i], bundle.problem.points[i]);
  }
  if (!move_others || corrections.empty()) return;
  std::vector<std::pair<uint32_t, Rigid3>> moved_frames;
  for (const auto& [index, frame] : session->keyframes()) {
    if (known_frames.count(index) != 0) continue;
    const Rigid3& new_from_old = corrections.at(ReferenceOf(corrections, index));
    moved_frames.emplace_back(index, frame.cam_from_session * Inverse(new_from_old));
  }
  for (const auto& [index, pose] : moved_frames) session->SetPose(index, pose);
  std::vector<std::pair<TrackId, Eigen::Vector3d>> moved_points;
  for (const auto& [id, landmark] : session->landmarks()) {
    if (known_tracks.count(id) != 0) continue;
    const uint32_t reference = ReferenceOf(corrections, landmark.observations.front().frame);
    moved_points.emplace_back(id, corrections.at(reference) * landmark.position);
  }
  for (const auto& [id, position] : moved_points) session->SetPosition(id, position);
}

}  // namespace rovio_sfm
