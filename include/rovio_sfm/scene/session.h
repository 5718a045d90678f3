#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/scene/session_journal.h"
#include "rovio_sfm/scene/session_parts.h"
#include "rovio_sfm/scene/session_record.h"
#include "rovio_sfm/scene/snapshot_blocks.h"
#include "rovio_sfm/scene/unsaved_parts.h"

namespace rovio_sfm {

// All state of one session: consecutive frames of one drive in one gauge (the first camera's).
// Keeps the invariants between frames, tracks and landmarks and does no work of its own.
// Thread-compatible.
class Session {
 public:
  Session(SessionId id, DriveId drive, Camera camera);
  // As it was kept; CheckInvariants says whether the record was sound.
  explicit Session(SessionRecord record);

  SessionId id() const { return id_; }
  const DriveId& drive() const { return drive_; }
  // What the frames came with, and what their features are normalised by: the same one until
  // SetCamera.
  const Camera& given_camera() const { return given_camera_; }
  const Camera& camera() const { return camera_; }
  SessionState state() const { return state_; }
  // Raised by every change: who keeps what it saw of a session compares.
  uint64_t revision() const { return revision_; }
  const std::optional<MapScale>& scale() const { return scale_; }
  const std::optional<OdometryDelay>& odometry_delay() const { return odometry_delay_; }
  const std::map<uint32_t, Keyframe>& keyframes() const { return keyframes_; }
  const std::map<uint32_t, LightFrame>& light_frames() const { return light_frames_; }
  const std::map<TrackId, Track>& tracks() const { return tracks_; }
  const std::map<TrackId, Landmark>& landmarks() const { return landmarks_; }
  TrackId RootOf(TrackId track) const;
  const Keyframe& keyframe(uint32_t index) const;
  const Landmark* FindLandmark(TrackId track) const;  // of the track's root; null if none

  void set_state(SessionState state);
  void set_scale(const MapScale& scale);
  void set_odometry_delay(const std::optional<OdometryDelay>& delay);

  // Another calibration of the same pictures: their features are normalised by it. False (and
  // nothing changes) where it cannot be inverted at one of them.
  bool SetCamera(const Camera& camera);

  // Adds a keyframe, its features normalised by given_camera(), with their tracks; ids may be any
  // alias. A second feature of one track in the frame is left without a track, and so is one where
  // camera() cannot be inverted. Light frames too come as given_camera() normalises them, and their
  // features lose their tracks so.
  void AddKeyframe(uint32_t index, Keyframe keyframe);
  // Removes a keyframe, its observations, and landmarks left with fewer than two.
  void RemoveKeyframe(uint32_t index);
  void AddLightFrame(uint32_t index, LightFrame frame);
  void SetPose(uint32_t index, const Rigid3& cam_from_session);
  void SetWeak(uint32_t index, bool weak);
  void SetLightPose(uint32_t index, uint32_t reference, const Rigid3& cam_from_reference,
                    uint32_t num_inliers);

  // A landmark for a track; observations must be members of it, two at least.
  void AddLandmark(TrackId track, const Eigen::Vector3d& position, Rgb color,
                   const std::vector<Observation>& observations);
  void RemoveLandmark(TrackId track);
  void SetPosition(TrackId track, const Eigen::Vector3d& position);
  // Adds a member of the landmark's track as an observation of it.
  void AddObservation(TrackId track, const Observation& observation);
  // Removes an observation (the feature stays a member); a landmark left with fewer than two goes.
  void RemoveObservation(TrackId track, Observation observation);

  // Puts a feature without a track, or alone in its own, into another track that has no member in
  // its frame. False if that does not hold.
  bool MoveToTrack(const Observation& observation, TrackId track);
  // Unites two tracks under the smaller root, unless both have members in one frame or both have
  // landmarks (then the caller decides with UniteLandmarks). True if they are one track now.
  bool UniteTracks(TrackId a, TrackId b);
  // Unites two tracks with landmarks under the smaller root at the position given; all observations
  // of both are kept. False (and nothing changes) where both have members in one frame.
  bool UniteLandmarks(TrackId a, TrackId b, const Eigen::Vector3d& position);

  // True where no single track could hold the members of both (f1).
  bool HasMembersInOneFrame(TrackId a, TrackId b) const;

  // A snapshot that shares the blocks which did not change since the last one.
  SessionSnapshot Snapshot() const;

  // From now on the journal keeps what is changed, so that RestoreTo can give it back.
  uint32_t Mark();
  // Frames, tracks, landmarks and scale are again what they were at the mark, to the byte; state
  // and odometry delay stay. That mark and later ones are gone.
  void RestoreTo(uint32_t mark);
  // What the journal keeps, bytes.
  size_t NumJournalBytes() const;
  const std::vector<SessionEpoch>& epochs() const { return epochs_; }
  uint32_t num_marks() const { return num_marks_; }
  const std::unordered_map<TrackId, TrackId>& aliases() const { return alias_; }

  // What changed since the last call.
  UnsavedParts TakeUnsaved();

 private:
  Keyframe& MutableKeyframe(uint32_t index);
  void Observe(const Observation& observation, bool observed);
  void MarkLandmark(TrackId track) const;
  void MarkFrame(uint32_t index) const;
  void NoteLandmark(TrackId track) { unsaved_.landmark_blocks.insert(track / kLandmarksPerBlock); }
  void MergeMembers(TrackId from, TrackId to);
  uint32_t Epoch() const { return epochs_.empty() ? 0 : epochs_.back().number; }
  void RememberPose(uint32_t index);
  void RememberMember(const Observation& member);
  void RememberLandmark(TrackId track);
  void RememberPosition(TrackId track);
  void RememberLightPose(uint32_t index);
  void RememberKeyframe(uint32_t index);
  void RememberLightFrame(uint32_t index);
  template <typename Frame>
  void Normalize(Frame* frame) const;
  void Undo(const SessionEpoch& epoch);
  void RebuildTracks();

  SessionId id_;
  DriveId drive_;
  Camera given_camera_, camera_;
  SessionState state_ = SessionState::kBootstrapping;
  uint64_t revision_ = 0;
  std::optional<MapScale> scale_;
  std::optional<OdometryDelay> odometry_delay_;
  std::map<uint32_t, Keyframe> keyframes_;
  std::map<uint32_t, LightFrame> light_frames_;
  std::map<TrackId, Track> tracks_;
  std::map<TrackId, Landmark> landmarks_;
  std::unordered_map<TrackId, TrackId> alias_;  // look-up only

  std::vector<SessionEpoch> epochs_;  // the journal; the last one is written
  uint32_t num_marks_ = 0;
  UnsavedParts unsaved_;

  // Blocks of the last snapshot by number (id / block size); a missing one changed since.
  mutable FrameBlocks frame_blocks_;
  mutable LandmarkBlocks landmark_blocks_;
  mutable std::set<uint32_t> moved_;  // keyframes since then: their light frames moved with them
};

// The landmark that a feature of the session, or of its keyframe, observes; null if none.
const Landmark* ObservedLandmark(const Session& session, const FeatureRef& feature);
const Landmark* ObservedLandmark(const Session& session, const Keyframe& keyframe,
                                 uint32_t feature);

// Names the first broken invariant between frames, tracks and landmarks; empty if all hold.
std::string CheckInvariants(const Session& session);

}  // namespace rovio_sfm
