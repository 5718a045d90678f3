#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {
namespace {

template <typename Map, typename Predicate>
void EraseIf(Map* map, const Predicate& predicate) {
  for (auto it = map->begin(); it != map->end();) {
    it = predicate(*it) ? map->erase(it) : std::next(it);
  }
}

// The oldest of a part's values stays.
template <typename Parts, typename Map>
void PutBack(const Parts& parts, Map* map) {
  for (auto it = parts.rbegin(); it != parts.rend(); ++it) (*map)[it->first] = *it->second;
}

// A part that is older than the epoch, before it goes or is replaced.
template <typename Map, typename Parts>
void Remember(const Map& map, typename Map::key_type key, uint32_t epoch, Parts* parts) {
  const auto it = map.find(key);
  if (it == map.end() || it->second.stamps.born == epoch) return;
  parts->emplace_back(key, std::make_shared<const typename Map::mapped_type>(it->second));
}

}  // namespace

uint32_t Session::Mark() {
  if (!epochs_.empty()) epochs_.back().Shrink();
  epochs_.emplace_back();
  epochs_.back().number = ++num_marks_;
  epochs_.back().scale = scale_;
  epochs_.back().camera = camera_;
  epochs_.back().poses.reserve(keyframes_.size());  // an adjustment of the map moves every one
  epochs_.back().positions.Reserve(landmarks_.size());
  return num_marks_;
}

void Session::RestoreTo(uint32_t mark) {
  ++revision_;
  Camera camera = camera_;
  while (!epochs_.empty() && epochs_.back().number >= mark) {
    Undo(epochs_.back());
    camera = epochs_.back().camera;
    epochs_.pop_back();
  }
  SetCamera(camera);
  RebuildTracks();
  frame_blocks_.clear();
  landmark_blocks_.clear();
  moved_.clear();
  unsaved_ = {};
  unsaved_.everything = true;
}

Session::Session(SessionRecord record)
    : id_(record.id),
      drive_(std::move(record.drive)),
      given_camera_(record.camera),
      camera_(record.camera),
      state_(record.state),
      scale_(std::move(record.scale)),
      odometry_delay_(record.odometry_delay),
      keyframes_(std::move(record.keyframes)),
      light_frames_(std::move(record.light_frames)),
      landmarks_(std::move(record.landmarks)),
      alias_(std::move(record.aliases)),
      epochs_(std::move(record.epochs)),
      num_marks_(record.num_marks) {
  RebuildTracks();
  if (record.refined_camera && !SetCamera(*record.refined_camera)) {
    throw std::runtime_error("session " + std::to_string(id_.value) +
                             ": its camera cannot be inverted at its features");
  }
}

UnsavedParts Session::TakeUnsaved() { return std::exchange(unsaved_, {}); }

size_t Session::NumJournalBytes() const {
  size_t count = 0;
  for (const SessionEpoch& epoch : epochs_) count += epoch.NumBytes();
  return count;
}

// The first of each in an epoch counts: later ones are taken back before it.
void Session::RememberPose(uint32_t index) {
  Keyframe& frame = MutableKeyframe(index);
  if (epochs_.empty() || frame.stamps.born == Epoch() || frame.stamps.moved == Epoch()) return;
  frame.stamps.moved = Epoch();
  epochs_.back().poses.push_back({index, frame.weak, frame.cam_from_session});
}

void Session::RememberLightPose(uint32_t index) {
  LightFrame& frame = light_frames_.at(index);
  if (epochs_.empty() || frame.stamps.born == Epoch() || frame.stamps.moved == Epoch()) return;
  frame.stamps.moved = Epoch();
  epochs_.back().light_poses.push_back(
      {index, frame.reference, frame.num_inliers, frame.cam_from_reference});
}

void Session::RememberMember(const Observation& member) {
  const Keyframe& frame = keyframe(member.frame);
  if (epochs_.empty() || frame.stamps.born == Epoch()) return;
  epochs_.back().members.push_back({member.frame, member.feature, frame.tracks[member.feature]});
}

void Session::RememberPosition(TrackId track) {
  Landmark& landmark = landmarks_.at(track);
  if (epochs_.empty() || landmark.stamps.born == Epoch() || landmark.stamps.moved == Epoch()) {
    return;
  }
  landmark.stamps.moved = Epoch();
  epochs_.back().positions.Add(track, landmark.position);
}

void Session::RememberLandmark(TrackId track) {
  Landmark& landmark = landmarks_.at(track);
  if (epochs_.empty() || landmark.stamps.changed == Epoch()) return;
  RememberPosition(track);
  landmark.stamps.changed = Epoch();
  Remember(landmarks_, track, Epoch(), &epochs_.back().landmarks);
}

void Session::RememberKeyframe(uint32_t index) {
  if (!epochs_.empty()) Remember(keyframes_, index, Epoch(), &epochs_.back().keyframes);
}

void Session::RememberLightFrame(uint32_t index) {
  if (!epochs_.empty()) Remember(light_frames_, index, Epoch(), &epochs_.back().light_frames);
}

void Session::Undo(const SessionEpoch& epoch) {
  const auto is_born = [&](const auto& part) { return part.second.stamps.born == epoch.number; };
  EraseIf(&keyframes_, is_born);
  EraseIf(&light_frames_, is_born);
  EraseIf(&landmarks_, is_born);
  PutBack(epoch.keyframes, &keyframes_);
  PutBack(epoch.light_frames, &light_frames_);
  PutBack(epoch.landmarks, &landmarks_);
  for (auto it = epoch.poses.rbegin(); it != epoch.poses.rend(); ++it) {
    Keyframe& frame = MutableKeyframe(it->frame);
    frame.weak = it->weak;
    frame.cam_from_session = it->cam_from_session;
  }
  for (auto it = epoch.light_poses.rbegin(); it != epoch.light_poses.rend(); ++it) {
    LightFrame& frame = light_frames_.at(it->frame);
    frame.reference = it->reference;
    frame.cam_from_reference = it->cam_from_reference;
    frame.num_inliers = it->num_inliers;
  }
  for (auto it = epoch.members.rbegin(); it != epoch.members.rend(); ++it) {
    MutableKeyframe(it->frame).tracks[it->feature] = it->track;
  }
  const auto positions = epoch.positions.List();
  for (auto it = positions.rbegin(); it != positions.rend(); ++it) {
    landmarks_.at(it->first).position = it->second;
  }
  for (const TrackId alias : epoch.aliases) alias_.erase(alias);
  scale_ = epoch.scale;
}

// Members and what features observe, anew from the frames' tracks and the landmarks.
void Session::RebuildTracks() {
  tracks_.clear();
  for (auto& [index, frame] : keyframes_) {
    frame.observed.assign(frame.tracks.size(), 0);
    frame.num_observed = 0;
    for (uint32_t feature = 0; feature < frame.tracks.size(); ++feature) {
      if (frame.tracks[feature] != 0)
        tracks_[frame.tracks[feature]].members.push_back({index, feature});
    }
  }
  for (const auto& [id, landmark] : landmarks_) {
    for (const Observation& observation : landmark.observations) {
      Keyframe& frame = MutableKeyframe(observation.frame);
      frame.observed[observation.feature] = 1;
      ++frame.num_observed;
    }
  }
}

}  // namespace rovio_sfm
