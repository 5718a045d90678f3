#include "rovio_sfm/scene/session.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/scene/snapshot_blocks.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

void Insert(std::vector<Observation>* sorted, const Observation& observation) {
  const auto at = std::lower_bound(sorted->begin(), sorted->end(), observation);
  ROVIO_CHECK(at == sorted->end() || at->frame != observation.frame);
  sorted->insert(at, observation);
}

bool Erase(std::vector<Observation>* sorted, const Observation& observation) {
  const auto at = std::lower_bound(sorted->begin(), sorted->end(), observation);
  if (at == sorted->end() || !(*at == observation)) return false;
  sorted->erase(at);
  return true;
}

bool SharesFrame(const std::vector<Observation>& a, const std::vector<Observation>& b) {
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (i->frame == j->frame) return true;
    (i->frame < j->frame) ? ++i : ++j;
  }
  return false;
}

bool HasFrame(const std::vector<Observation>& sorted, uint32_t frame) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), Observation{frame, 0});
  return at != sorted.end() && at->frame == frame;
}

}  // namespace

Session::Session(SessionId id, DriveId drive, Camera camera)
    : id_(id), drive_(std::move(drive)), given_camera_(camera), camera_(camera) {}

TrackId Session::RootOf(TrackId track) const {
  for (auto it = alias_.find(track); it != alias_.end(); it = alias_.find(track)) {
    track = it->second;
  }
  return track;
}

const Keyframe& Session::keyframe(uint32_t index) const {
  const auto it = keyframes_.find(index);
  ROVIO_CHECK(it != keyframes_.end(), "no keyframe " + std::to_string(index));
  return it->second;
}

Keyframe& Session::MutableKeyframe(uint32_t index) {
  return const_cast<Keyframe&>(std::as_const(*this).keyframe(index));
}

const Landmark* Session::FindLandmark(TrackId track) const {
  const auto it = landmarks_.find(RootOf(track));
  return it == landmarks_.end() ? nullptr : &it->second;
}

void Session::set_state(SessionState state) {
  ++revision_;
  state_ = state;
}

void Session::set_scale(const MapScale& scale) {
  ++revision_;
  scale_ = scale;
}

void Session::set_odometry_delay(const std::optional<OdometryDelay>& delay) {
  ++revision_;
  odometry_delay_ = delay;
}

void Session::AddKeyframe(uint32_t index, Keyframe keyframe) {
  ++revision_;
  ROVIO_CHECK(keyframes_.count(index) == 0 && light_frames_.count(index) == 0);
  const size_t size = keyframe.points.size();
  ROVIO_CHECK(keyframe.tracks.size() == size && keyframe.sigmas.size() == size &&
              keyframe.colors.size() == size);
  Normalize(&keyframe);
  keyframe.stamps.born = Epoch();
  keyframe.observed.assign(size, 0);
  keyframe.num_observed = 0;
  for (uint32_t feature = 0; feature < size; ++feature) {
    TrackId& track = keyframe.tracks[feature];
    if (track == 0) continue;
    track = RootOf(track);
    Track& members = tracks_[track];
    if (HasFrame(members.members, index)) {
      track = 0;
    } else {
      Insert(&members.members, {index, feature});
    }
  }
  keyframes_.emplace(index, std::move(keyframe));
  unsaved_.poses.insert(index);
  unsaved_.tracks.insert(index);
  MarkFrame(index);
}

void Session::RemoveKeyframe(uint32_t index) {
  ++revision_;
  for (uint32_t feature = 0; feature < keyframe(index).tracks.size(); ++feature) {
    const TrackId track = keyframe(index).tracks[feature];
    if (track == 0) continue;
    if (keyframe(index).observed[feature]) RemoveObservation(track, {index, feature});
    const auto it = tracks_.find(track);
    Erase(&it->second.members, {index, feature});
    if (it->second.members.empty()) tracks_.erase(it);
  }
  RememberKeyframe(index);
  keyframes_.erase(index);
  unsaved_.poses.insert(index);
  MarkFrame(index);
  for (auto it = light_frames_.begin(); it != light_frames_.end();) {
    const bool orphan = it->second.reference == index;
    if (orphan) {
      RememberLightPose(it->first);
      RememberLightFrame(it->first);
      unsaved_.poses.insert(it->first);
      MarkFrame(it->first);
    }
    it = orphan ? light_frames_.erase(it) : std::next(it);
  }
}

void Session::AddLightFrame(uint32_t index, LightFrame frame) {
  ++revision_;
  ROVIO_CHECK(keyframes_.count(index) == 0 && keyframes_.count(frame.reference) == 1);
  RememberLightFrame(index);
  Normalize(&frame);
  frame.stamps.born = Epoch();
  light_frames_[index] = std::move(frame);
  unsaved_.poses.insert(index);
  MarkFrame(index);
}

void Session::SetPose(uint32_t index, const Rigid3& cam_from_session) {
  ++revision_;
  RememberPose(index);
  Keyframe& frame = MutableKeyframe(index);
  frame.cam_from_session = cam_from_session;
  unsaved_.poses.insert(index);
  MarkFrame(index);
  moved_.insert(index);
  for (size_t i = 0; i < frame.tracks.size(); ++i) {
    if (frame.observed[i]) MarkLandmark(frame.tracks[i]);
  }
}

void Session::SetWeak(uint32_t index, bool weak) {
  ++revision_;
  RememberPose(index);
  MutableKeyframe(index).weak = weak;
  unsaved_.poses.insert(index);
  MarkFrame(index);
}

void Session::SetLightPose(uint32_t index, uint32_t reference, const Rigid3& cam_from_reference,
                           uint32_t num_inliers) {
  ROVIO_CHECK(keyframes_.count(reference) == 1);
  ++revision_;
  RememberLightPose(index);
  LightFrame& frame = light_frames_.at(index);
  frame.reference = reference;
  frame.cam_from_reference = cam_from_reference;
  frame.num_inliers = num_inliers;
  unsaved_.poses.insert(index);
  MarkFrame(index);
}

void Session::Observe(const Observation& observation, bool observed) {
  Keyframe& frame = MutableKeyframe(observation.frame);
  uint8_t& flag = frame.observed[observation.feature];
  ROVIO_CHECK((flag == 1) != observed);
  flag = observed ? 1 : 0;
  frame.num_observed = observed ? frame.num_observed + 1 : frame.num_observed - 1;
  MarkFrame(observation.frame);
}

void Session::AddLandmark(TrackId track, const Eigen::Vector3d& position, Rgb color,
                          const std::vector<Observation>& observations) {
  ++revision_;
  ROVIO_CHECK(observations.size() >= 2 && landmarks_.count(track) == 0);
  ROVIO_CHECK(tracks_.count(track) == 1);
  landmarks_[track] = {position, color, {}, {Epoch(), Epoch(), Epoch()}};
  for (const Observation& observation : observations) AddObservation(track, observation);
}

void Session::RemoveLandmark(TrackId track) {
  ++revision_;
  const auto it = landmarks_.find(track);
  ROVIO_CHECK(it != landmarks_.end());
  RememberLandmark(track);
  for (const Observation& observation : it->second.observations) Observe(observation, false);
  landmarks_.erase(it);
  NoteLandmark(track);
  MarkLandmark(track);
}

void Session::SetPosition(TrackId track, const Eigen::Vector3d& position) {
  ++revision_;
  RememberPosition(track);
  landmarks_.at(track).position = position;
  NoteLandmark(track);
  MarkLandmark(track);
}

void Session::AddObservation(TrackId track, const Observation& observation) {
  ++revision_;
  ROVIO_CHECK(keyframe(observation.frame).tracks[observation.feature] == track);
  RememberLandmark(track);
  Insert(&landmarks_.at(track).observations, observation);
  Observe(observation, true);
  NoteLandmark(track);
  MarkLandmark(track);
}

void Session::RemoveObservation(TrackId track, Observation observation) {
  ++revision_;
  RememberLandmark(track);
  Landmark& landmark = landmarks_.at(track);
  ROVIO_CHECK(Erase(&landmark.observations, observation));
  Observe(observation, false);
  NoteLandmark(track);
  MarkLandmark(track);
  if (landmark.observations.size() < 2) RemoveLandmark(track);
}

bool Session::MoveToTrack(const Observation& observation, TrackId track) {
  ++revision_;
  Keyframe& frame = MutableKeyframe(observation.frame);
  const TrackId old = frame.tracks[observation.feature];
  if (frame.observed[observation.feature] || old == track) return false;
  if (HasFrame(tracks_.at(track).members, observation.frame)) return false;
  if (old != 0) {
    if (tracks_.at(old).members.size() > 1) return false;
    tracks_.erase(old);
  }
  RememberMember(observation);
  frame.tracks[observation.feature] = track;
  unsaved_.tracks.insert(observation.frame);
  Insert(&tracks_.at(track).members, observation);
  return true;
}

bool Session::HasMembersInOneFrame(TrackId a, TrackId b) const {
  const auto i = tracks_.find(RootOf(a));
  const auto j = tracks_.find(RootOf(b));
  if (i == tracks_.end() || j == tracks_.end() || i == j) return false;
  return SharesFrame(i->second.members, j->second.members);
}

void Session::MergeMembers(TrackId from, TrackId to) {
  ++revision_;
  const auto it = tracks_.find(from);
  if (it != tracks_.end()) {
    Track& target = tracks_[to];
    for (const Observation& member : it->second.members) {
      Insert(&target.members, member);
      RememberMember(member);
      MutableKeyframe(member.frame).tracks[member.feature] = to;
      unsaved_.tracks.insert(member.frame);
    }
    tracks_.erase(it);
  }
  alias_[from] = to;
  unsaved_.aliases.push_back(from);
  if (!epochs_.empty()) epochs_.back().aliases.push_back(from);
}

bool Session::UniteTracks(TrackId a, TrackId b) {
  a = RootOf(a);
  b = RootOf(b);
  if (a == b) return true;
  if (HasMembersInOneFrame(a, b)) return false;
  if (landmarks_.count(a) == 1 && landmarks_.count(b) == 1) return false;
  const TrackId root = std::min(a, b), other = std::max(a, b);
  const auto it = landmarks_.find(other);
  std::optional<Landmark> moved;
  if (it != landmarks_.end()) {
    moved = it->second;
    RemoveLandmark(other);
  }
  MergeMembers(other, root);
  if (moved) AddLandmark(root, moved->position, moved->color, moved->observations);
  return true;
}

bool Session::UniteLandmarks(TrackId a, TrackId b, const Eigen::Vector3d& position) {
  a = RootOf(a);
  b = RootOf(b);
  if (a == b) return true;
  if (HasMembersInOneFrame(a, b)) return false;
  const TrackId root = std::min(a, b), other = std::max(a, b);
  const std::vector<Observation> moved = landmarks_.at(other).observations;
  RemoveLandmark(other);
  MergeMembers(other, root);
  for (const Observation& observation : moved) AddObservation(root, observation);
  SetPosition(root, position);
  return true;
}

SessionSnapshot Session::Snapshot() const {
  SessionSnapshot snapshot;
  snapshot.id = id_;
  snapshot.revision = revision_;
  snapshot.map = {id_.value};
  snapshot.drive = drive_;
  snapshot.given_camera = given_camera_;
  snapshot.camera = camera_;
  snapshot.state = state_;
  snapshot.scale = scale_;
  snapshot.odometry_delay = odometry_delay_;
  for (const auto& [index, frame] : light_frames_) {
    if (moved_.count(frame.reference) == 1) MarkFrame(index);
  }
  moved_.clear();
  snapshot.frames = UpdateFrameBlocks(keyframes_, light_frames_, &frame_blocks_);
  snapshot.landmarks = UpdateLandmarkBlocks(camera_, keyframes_, landmarks_, &landmark_blocks_);
  return snapshot;
}

void Session::MarkLandmark(TrackId track) const {
  landmark_blocks_.erase(track / kLandmarksPerBlock);
}

void Session::MarkFrame(uint32_t index) const { frame_blocks_.erase(index / kFramesPerBlock); }

const Landmark* ObservedLandmark(const Session& session, const FeatureRef& feature) {
  const auto frame = session.keyframes().find(feature.frame);
  if (frame == session.keyframes().end()) return nullptr;
  return ObservedLandmark(session, frame->second, feature.feature);
}

const Landmark* ObservedLandmark(const Session& session, const Keyframe& keyframe,
                                 uint32_t feature) {
  if (feature >= keyframe.observed.size() || !keyframe.observed[feature]) return nullptr;
  return session.FindLandmark(keyframe.tracks[feature]);
}

}  // namespace rovio_sfm
