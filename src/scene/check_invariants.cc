#include <algorithm>
#include <string>

#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {
namespace {

std::string Name(TrackId track) { return "track " + std::to_string(track); }

std::string CheckTrack(const Session& session, TrackId id, const Track& track) {
  if (track.members.empty()) return Name(id) + " has no members";
  for (size_t i = 0; i < track.members.size(); ++i) {
    const Observation& member = track.members[i];
    if (session.keyframes().count(member.frame) == 0) return Name(id) + " in an unknown frame";
    if (session.keyframe(member.frame).tracks.at(member.feature) != id) {
      return Name(id) + " is not its member's track";
    }
    if (i > 0 && track.members[i - 1].frame >= member.frame) {
      return Name(id) + " has two members in a frame, or unsorted ones";
    }
  }
  return "";
}

std::string CheckLandmark(const Session& session, TrackId id, const Landmark& landmark) {
  if (landmark.observations.size() < 2) return Name(id) + " has a landmark of fewer than two views";
  if (!landmark.position.allFinite()) return Name(id) + " has a landmark that is not finite";
  const auto track = session.tracks().find(id);
  if (track == session.tracks().end()) return Name(id) + " has a landmark but no members";
  const auto& members = track->second.members;
  for (const Observation& observation : landmark.observations) {
    if (!std::binary_search(members.begin(), members.end(), observation)) {
      return Name(id) + " is observed by a feature that is not a member";
    }
    if (!session.keyframe(observation.frame).observed.at(observation.feature)) {
      return Name(id) + " has an observation that its frame does not know";
    }
  }
  return "";
}

std::string CheckKeyframe(const Session& session, uint32_t index, const Keyframe& frame) {
  const auto count = std::count(frame.observed.begin(), frame.observed.end(), uint8_t{1});
  if (static_cast<uint32_t>(count) != frame.num_observed) {
    return "frame " + std::to_string(index) + " miscounts its observations";
  }
  for (size_t i = 0; i < frame.tracks.size(); ++i) {
    if (!frame.observed[i]) continue;
    const Landmark* landmark = session.FindLandmark(frame.tracks[i]);
    const Observation self{index, static_cast<uint32_t>(i)};
    if (landmark == nullptr ||
        !std::binary_search(landmark->observations.begin(), landmark->observations.end(), self)) {
      return "frame " + std::to_string(index) + " observes a landmark that does not know it";
    }
  }
  return "";
}

}  // namespace

std::string CheckInvariants(const Session& session) {
  std::string broken;
  for (const auto& [id, track] : session.tracks()) {
    if (!(broken = CheckTrack(session, id, track)).empty()) return broken;
  }
  for (const auto& [id, landmark] : session.landmarks()) {
    if (!(broken = CheckLandmark(session, id, landmark)).empty()) return broken;
  }
  for (const auto& [index, frame] : session.keyframes()) {
    if (!(broken = CheckKeyframe(session, index, frame)).empty()) return broken;
  }
  for (const auto& [index, frame] : session.light_frames()) {
    if (session.keyframes().count(frame.reference) == 0) {
      return "light frame " + std::to_string(index) + " has no reference";
    }
  }
  return broken;
}

}  // namespace rovio_sfm
