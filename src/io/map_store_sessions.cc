#include "rovio_sfm/io/map_store_sessions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "rovio_sfm/io/map_store_codec.h"
#include "rovio_sfm/scene/snapshot_blocks.h"

namespace rovio_sfm {
namespace {

struct ScaleColumns {
  std::optional<double> metres_per_unit, sigma_log;
  std::optional<std::string> source;
};

ScaleColumns ColumnsOf(const std::optional<MapScale>& scale) {
  if (!scale) return {};
  return {scale->metres_per_unit, scale->sigma_log, scale->source};
}

std::optional<MapScale> ReadScale(const Rows& rows, int column) {
  if (rows.IsNull(column)) return std::nullopt;
  const MapScale scale{rows.Double(column), rows.Double(column + 1), rows.Text(column + 2)};
  if (!(scale.metres_per_unit > 0.0 && std::isfinite(scale.metres_per_unit))) {
    throw StoreError("metres_per_unit = " + std::to_string(scale.metres_per_unit) +
                     ": expected more than 0");
  }
  return scale;
}

Rigid3 ReadPoseOf(uint32_t frame, const Blob& bytes) {
  return WithFileNamed("frame " + std::to_string(frame), [&] { return ReadPose(bytes); });
}

EpochStamps ReadStamps(const Rows& rows, int column) {
  return {static_cast<uint32_t>(rows.Int(column)), static_cast<uint32_t>(rows.Int(column + 1)), 0};
}

UnsavedParts AllOf(const Session& session) {
  UnsavedParts all;
  for (const auto& [index, frame] : session.keyframes()) all.tracks.insert(index);
  all.poses = all.tracks;
  for (const auto& [index, frame] : session.light_frames()) all.poses.insert(index);
  for (const auto& [id, landmark] : session.landmarks()) {
    all.landmark_blocks.insert(id / kLandmarksPerBlock);
  }
  for (const auto& [track, united_with] : session.aliases()) all.aliases.push_back(track);
  std::sort(all.aliases.begin(), all.aliases.end());
  return all;
}

// The first landmark whose observations are no features of its frames; empty if all are.
std::string FindStrayObservation(const SessionRecord& record) {
  for (const auto& [id, landmark] : record.landmarks) {
    for (const Observation& observation : landmark.observations) {
      const auto frame = record.keyframes.find(observation.frame);
      if (frame == record.keyframes.end() || observation.feature >= frame->second.tracks.size()) {
        return "landmark " + std::to_string(id) + " is observed by feature " +
               std::to_string(observation.feature) + " of frame " +
               std::to_string(observation.frame) + ", which is not there";
      }
    }
  }
  return "";
}

}  // namespace

void StoredSessions::Put(Session* session) {
  const auto [known, is_new] = kept_.try_emplace(session->id());
  Kept& kept = known->second;
  if (kept.revision == session->revision()) return;
  UnsavedParts unsaved = session->TakeUnsaved();
  const int64_t drive = frames_->RowOf(session->drive(), session->given_camera());
  PutRow(*session, drive);
  PutCameras(*session);
  if (unsaved.everything || is_new) {
    Forget(session->id());
    kept.epochs.clear();
    unsaved = AllOf(*session);
  }
  for (const uint32_t index : unsaved.poses) PutPose(*session, drive, index);
  PutTracks(*session, drive, unsaved);
  PutEpochs(*session, &kept);
  kept.revision = session->revision();
}

void StoredSessions::PutTracks(const Session& session, int64_t drive, const UnsavedParts& unsaved) {
  for (const uint32_t index : unsaved.tracks) {
    const auto frame = session.keyframes().find(index);
    if (frame == session.keyframes().end()) continue;  // it went: so did its row
    const std::string bytes = TrackBytes(frame->second.tracks);
    database_->Run(
        "INSERT OR REPLACE INTO keyframe_tracks (session, frame, tracks) VALUES (?, ?, ?)",
        session.id().value, StoredFrames::FrameRow(drive, index), BlobOf(bytes));
  }
  for (const uint64_t block : unsaved.landmark_blocks) {
    const TrackId first = block * kLandmarksPerBlock;
    const std::string bytes = LandmarkBytes(session.landmarks(), first, first + kLandmarksPerBlock);
    if (bytes.empty()) {
      database_->Run("DELETE FROM landmark_block WHERE session = ? AND block = ?",
                     session.id().value, block);
      continue;
    }
    database_->Run(
        "INSERT OR REPLACE INTO landmark_block (session, block, landmarks) VALUES (?, ?, ?)",
        session.id().value, block, BlobOf(bytes));
  }
  for (const TrackId track : unsaved.aliases) {
    database_->Run(
        "INSERT OR REPLACE INTO track_alias (session, track, united_with) VALUES (?, ?, ?)",
        session.id().value, track, session.aliases().at(track));
  }
}

void StoredSessions::Forget(SessionId id) {
  database_->Run("DELETE FROM light_pose WHERE session = ?", id.value);
  database_->Run("DELETE FROM keyframe WHERE session = ?", id.value);
  database_->Run("DELETE FROM landmark_block WHERE session = ?", id.value);
  database_->Run("DELETE FROM track_alias WHERE session = ?", id.value);
  database_->Run("DELETE FROM journal WHERE session = ?", id.value);
}

void StoredSessions::PutRow(const Session& session, int64_t drive) {
  const ScaleColumns scale = ColumnsOf(session.scale());
  std::optional<double> delay_s, delay_sigma_s;
  if (session.odometry_delay()) {
    delay_s = session.odometry_delay()->delay_s;
    delay_sigma_s = session.odometry_delay()->sigma_s;
  }
  database_->Run(
      "INSERT INTO session (id, drive, state, metres_per_unit, sigma_log_scale, scale_source, "
      "odometry_delay_s, odometry_delay_sigma_s, num_marks) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) "
      "ON CONFLICT (id) DO UPDATE SET state = excluded.state, metres_per_unit = "
      "excluded.metres_per_unit, sigma_log_scale = excluded.sigma_log_scale, scale_source = "
      "excluded.scale_source, odometry_delay_s = excluded.odometry_delay_s, "
      "odometry_delay_sigma_s = excluded.odometry_delay_sigma_s, num_marks = excluded.num_marks",
      session.id().value, drive, static_cast<int>(session.state()), scale.metres_per_unit,
      scale.sigma_log, scale.source, delay_s, delay_sigma_s, session.num_marks());
}

// Of now (mark 0) and of the journal's marks, where they are not the drive's.
void StoredSessions::PutCameras(const Session& session) {
  database_->Run("DELETE FROM session_camera WHERE session = ?", session.id().value);
  const auto put = [&](uint32_t mark, const Camera& camera) {
    if (camera == session.given_camera()) return;
    database_->Run(
        "INSERT INTO session_camera (session, mark, fx, fy, cx, cy) VALUES (?, ?, ?, ?, ?, ?)",
        session.id().value, mark, camera.fx, camera.fy, camera.cx, camera.cy);
  };
  put(0, session.camera());
  for (const SessionEpoch& epoch : session.epochs()) put(epoch.number, epoch.camera);
}

void StoredSessions::PutPose(const Session& session, int64_t drive, uint32_t index) {
  const int64_t row = StoredFrames::FrameRow(drive, index);
  const auto frame = session.keyframes().find(index);
  const auto light = session.light_frames().find(index);
  if (frame != session.keyframes().end()) {
    const Keyframe& keyframe = frame->second;
    const std::string pose = PoseBytes(keyframe.cam_from_session);
    database_->Run(
        "INSERT INTO keyframe (session, frame, is_weak, pose, born, moved) VALUES (?, ?, ?, ?, ?, "
        "?) ON CONFLICT (session, frame) DO UPDATE SET is_weak = excluded.is_weak, pose = "
        "excluded.pose, born = excluded.born, moved = excluded.moved",
        session.id().value, row, keyframe.weak ? 1 : 0, BlobOf(pose), keyframe.stamps.born,
        keyframe.stamps.moved);
  } else {
    database_->Run("DELETE FROM keyframe WHERE session = ? AND frame = ?", session.id().value, row);
  }
  if (light != session.light_frames().end()) {
    const LightFrame& posed = light->second;
    const std::string pose = PoseBytes(posed.cam_from_reference);
    database_->Run(
        "INSERT OR REPLACE INTO light_pose (session, frame, reference, pose, num_inliers, born, "
        "moved) VALUES (?, ?, ?, ?, ?, ?, ?)",
        session.id().value, row, StoredFrames::FrameRow(drive, posed.reference), BlobOf(pose),
        posed.num_inliers, posed.stamps.born, posed.stamps.moved);
  } else {
    database_->Run("DELETE FROM light_pose WHERE session = ? AND frame = ?", session.id().value,
                   row);
  }
}

void StoredSessions::PutEpochs(const Session& session, Kept* kept) {
  for (const SessionEpoch& epoch : session.epochs()) {
    const EpochSizes sizes = SizesOf(epoch);
    const auto [known, is_new] = kept->epochs.emplace(epoch.number, EpochSizes{});
    if (!is_new && known->second == sizes) continue;
    const ScaleColumns scale = ColumnsOf(epoch.scale);
    const std::string bytes = EpochBytes(epoch, known->second);
    database_->Run(
        "INSERT INTO journal (session, mark, metres_per_unit, sigma_log_scale, scale_source, "
        "entries) VALUES (?, ?, ?, ?, ?, ?)",
        session.id().value, epoch.number, scale.metres_per_unit, scale.sigma_log, scale.source,
        BlobOf(bytes));
    known->second = sizes;
  }
}

std::vector<SessionId> StoredSessions::ReadIds() const {
  std::vector<SessionId> ids;
  Rows rows = database_->Query("SELECT id FROM session ORDER BY id");
  while (rows.Next()) ids.push_back({static_cast<uint32_t>(rows.Int(0))});
  return ids;
}

std::vector<SessionRecord> StoredSessions::Read(const FrameMaker& make,
                                                std::vector<std::string>* unreadable) {
  std::vector<SessionRecord> records;
  for (const SessionId id : ReadIds()) {
    const std::string where = "session " + std::to_string(id.value) + ": ";
    const auto read = [&] { return ReadSession(id, make); };
    try {
      records.push_back(WithFileNamed(database_->file(), read, where));
    } catch (const StoreError& error) {
      if (unreadable == nullptr) throw;
      unreadable->push_back(error.what());
      continue;
    }
    kept_[id] = {std::nullopt, {}};
    for (const SessionEpoch& epoch : records.back().epochs) {
      kept_[id].epochs[epoch.number] = SizesOf(epoch);
    }
  }
  return records;
}

SessionRecord StoredSessions::ReadSession(SessionId id, const FrameMaker& make) const {
  SessionRecord record;
  record.id = id;
  {
    Rows rows = database_->Query(
        "SELECT drive, state, metres_per_unit, sigma_log_scale, scale_source, odometry_delay_s, "
        "odometry_delay_sigma_s, num_marks FROM session WHERE id = ?",
        id.value);
    rows.Next();
    record.drive = frames_->DriveAt(rows.Int(0));
    record.camera = frames_->CameraAt(rows.Int(0));
    record.state = ReadEnum(rows, 1, SessionState::kLost, "session.state");
    record.scale = ReadScale(rows, 2);
    if (!rows.IsNull(5)) record.odometry_delay = OdometryDelay{rows.Double(5), rows.Double(6)};
    record.num_marks = static_cast<uint32_t>(rows.Int(7));
  }
  ReadKeyframes(make, &record);
  ReadLightFrames(make, &record);
  ReadPoints(&record);
  ReadEpochs(make, &record);
  ReadCameras(&record);
  const std::string stray = FindStrayObservation(record);
  if (!stray.empty()) throw StoreError(stray);
  return record;
}

void StoredSessions::ReadKeyframes(const FrameMaker& make, SessionRecord* record) const {
  Rows rows = database_->Query(
      "SELECT frame, is_weak, pose, born, moved, tracks FROM keyframe "
      "LEFT JOIN keyframe_tracks USING (session, frame) WHERE session = ? ORDER BY frame",
      record->id.value);
  while (rows.Next()) {
    const uint32_t index = StoredFrames::IndexOfRow(rows.Int(0));
    Keyframe frame = make.keyframe(BareEvent(record->drive, index));
    frame.weak = rows.Int(1) == 1;
    frame.cam_from_session = ReadPoseOf(index, rows.Bytes(2));
    frame.stamps = ReadStamps(rows, 3);
    frame.tracks = ReadTracks(rows.Bytes(5));  // none where the row is missing
    if (frame.tracks.size() != frame.points.size()) {
      throw StoreError("frame " + std::to_string(index) + ": " +
                       std::to_string(frame.tracks.size()) + " tracks, expected " +
                       std::to_string(frame.points.size()) + ", as many as keypoints");
    }
    record->keyframes.emplace(index, std::move(frame));
  }
}

void StoredSessions::ReadLightFrames(const FrameMaker& make, SessionRecord* record) const {
  Rows rows = database_->Query(
      "SELECT frame, reference, pose, num_inliers, born, moved FROM light_pose WHERE session = ? "
      "ORDER BY frame",
      record->id.value);
  while (rows.Next()) {
    const uint32_t index = StoredFrames::IndexOfRow(rows.Int(0));
    LightFrame frame = make.light_frame(BareEvent(record->drive, index));
    frame.reference = StoredFrames::IndexOfRow(rows.Int(1));
    frame.cam_from_reference = ReadPoseOf(index, rows.Bytes(2));
    frame.num_inliers = static_cast<uint32_t>(rows.Int(3));
    frame.stamps = ReadStamps(rows, 4);
    record->light_frames.emplace(index, std::move(frame));
  }
}

void StoredSessions::ReadPoints(SessionRecord* record) const {
  Rows blocks =
      database_->Query("SELECT landmarks FROM landmark_block WHERE session = ?", record->id.value);
  while (blocks.Next()) ReadLandmarks(blocks.Bytes(0), &record->landmarks);
  Rows aliases = database_->Query("SELECT track, united_with FROM track_alias WHERE session = ?",
                                  record->id.value);
  while (aliases.Next()) {
    record->aliases[static_cast<TrackId>(aliases.Int(0))] = static_cast<TrackId>(aliases.Int(1));
  }
}

void StoredSessions::ReadEpochs(const FrameMaker& make, SessionRecord* record) const {
  Rows rows = database_->Query(
      "SELECT mark, metres_per_unit, sigma_log_scale, scale_source, entries FROM journal "
      "WHERE session = ? ORDER BY mark, id",
      record->id.value);
  const EventOf event_of = [&](uint32_t index) { return BareEvent(record->drive, index); };
  while (rows.Next()) {
    const auto mark = static_cast<uint32_t>(rows.Int(0));
    if (record->epochs.empty() || record->epochs.back().number != mark) {
      record->epochs.emplace_back();
      record->epochs.back().number = mark;
      record->epochs.back().scale = ReadScale(rows, 1);
    }
    ReadEpoch(rows.Bytes(4), make, event_of, &record->epochs.back());
  }
}

void StoredSessions::ReadCameras(SessionRecord* record) const {
  std::map<uint32_t, Camera> at_mark;
  Rows rows = database_->Query("SELECT mark, fx, fy, cx, cy FROM session_camera WHERE session = ?",
                               record->id.value);
  while (rows.Next()) {
    Camera camera = record->camera;
    camera.fx = rows.Double(1);
    camera.fy = rows.Double(2);
    camera.cx = rows.Double(3);
    camera.cy = rows.Double(4);
    std::string error;
    if (!camera.IsValid(&error)) throw StoreError("session_camera: " + error);
    at_mark[static_cast<uint32_t>(rows.Int(0))] = camera;
  }
  if (const auto now = at_mark.find(0); now != at_mark.end()) record->refined_camera = now->second;
  for (SessionEpoch& epoch : record->epochs) {
    const auto found = at_mark.find(epoch.number);
    epoch.camera = found == at_mark.end() ? record->camera : found->second;
  }
}

FrameEvent StoredSessions::BareEvent(const DriveId& drive, uint32_t index) const {
  auto event = frames_->ReadEvent({drive, index}, EventParts::kBare);
  if (event) return std::move(*event);
  throw StoreError("frame " + std::to_string(index) + " of drive " + drive.ToString() +
                   " is missing");
}

}  // namespace rovio_sfm
