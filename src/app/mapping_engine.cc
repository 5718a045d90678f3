#include "rovio_sfm/app/mapping_engine.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

MappingEngine::MappingEngine(const MapOptions& options)
    : options_(options), state_(std::make_unique<State>(options)) {
  Show();
}

MapperReport MappingEngine::Add(const FrameEvent& event) {
  ++num_events_;
  MapperReport report;
  report.outcome = MapperOutcome::kRefused;
  if (!EnterDrive(event.id.drive, &report.reason)) return report;
  next_indices_[event.id.drive] = event.id.index + 1;
  report = state_->mapper.Add(event);
  const bool is_registered =
      report.outcome == MapperOutcome::kKeyframe || report.outcome == MapperOutcome::kLight;
  if (is_registered) {
    anchors_[event.id.drive.robot] = {report.session, event.id.index, event.odometry};
  }
  Show();
  return report;
}

void MappingEngine::Add(const PlaceMatch& match) {
  ++num_place_matches_;
  state_->mapper.Add(match);
  Show();
}

void MappingEngine::ApplyDueResults() {
  if (state_->mapper.ApplyDueResults()) Show();
}

MergeReport MappingEngine::Merge(SessionId a, SessionId b, bool force) {
  MergeReport report = state_->mapper.Merge(a, b, force);
  Show();
  return report;
}

MergeReport MappingEngine::MergeAt(SessionId a, SessionId b, const Sim3& b_from_a) {
  const auto snapshot = Picture().snapshot;
  const SessionSnapshot* session_a = FindSession(*snapshot, a);
  const SessionSnapshot* session_b = FindSession(*snapshot, b);
  ROVIO_CHECK(session_a != nullptr && session_b != nullptr, "a session is not known");
  const std::optional<Sim3> level_a = LevelInUnitOfMap(*session_a);
  const std::optional<Sim3> level_b = LevelInUnitOfMap(*session_b);
  ROVIO_CHECK(level_a && level_b, "a session has no frame");
  MergeReport report = state_->mapper.MergeAt(a, b, Inverse(*level_b) * b_from_a * *level_a);
  Show();
  return report;
}

std::vector<MergeReport> MappingEngine::Unmerge(SessionId id) {
  std::vector<MergeReport> undone = state_->mapper.Unmerge(id);
  Show();
  return undone;
}

bool MappingEngine::EnterDrive(const DriveId& drive, std::string* error) {
  const auto current = current_drives_.find(drive.robot);
  if (current != current_drives_.end() && current->second == drive) return true;
  if (ended_drives_.count(drive) > 0) {
    *error = "robot " + drive.robot + ": its drive " + drive.ToString() +
             " ended when the next began; do two frontends share the name?";
    return false;
  }
  if (current != current_drives_.end()) {
    state_->mapper.FinishSession(current->second);
    ended_drives_.insert(current->second);
  }
  current_drives_[drive.robot] = drive;
  return true;
}

uint32_t MappingEngine::NextIndex(const FrameId& id) const {
  if (ended_drives_.count(id.drive) > 0) return id.index;
  const auto next = next_indices_.find(id.drive);
  return next == next_indices_.end() ? 0 : std::min(next->second, id.index);
}

// The drive's newest session, unless it is closed.
std::optional<SessionId> MappingEngine::RunningSession(const DriveId& drive) const {
  const auto snapshot = Picture().snapshot;
  std::optional<SessionId> running;
  for (const SessionSnapshot& session : snapshot->sessions) {
    if (session.drive != drive) continue;
    const bool is_closed =
        session.state == SessionState::kFinished || session.state == SessionState::kLost;
    running = is_closed ? std::nullopt : std::optional<SessionId>(session.id);
  }
  return running;
}

std::optional<ClosedSession> MappingEngine::FinishSession(const std::string& robot) {
  const auto drive = current_drives_.find(robot);
  if (drive == current_drives_.end()) return std::nullopt;
  const std::optional<SessionId> running = RunningSession(drive->second);
  if (!running || !state_->mapper.FinishSession(drive->second)) return std::nullopt;
  Show();
  const auto snapshot = Picture().snapshot;
  const SessionSnapshot* session = FindSession(*snapshot, *running);
  return ClosedSession{*running, session != nullptr && !session->frames.empty()};
}

void MappingEngine::Finish() {
  state_->mapper.Finish();
  Show();
}

void MappingEngine::Reset() {
  state_.reset();
  state_ = std::make_unique<State>(options_);
  anchors_.clear();
  ++epoch_;
  Show();
}

void MappingEngine::Show() {
  MapPicture picture = Picture();
  ++picture.number;
  picture.epoch = epoch_;
  picture.snapshot = state_->mapper.Snapshot();
  picture.anchors = anchors_;
  picture.counters = state_->mapper.counters();
  picture.num_events = num_events_;
  std::vector<MergeReport> merges = state_->mapper.MergeReports();
  if (!(merges == *picture.merges)) {
    picture.merges = std::make_shared<const std::vector<MergeReport>>(std::move(merges));
  }
  picture.num_place_matches = num_place_matches_;
  picture.num_matches_waiting = state_->mapper.num_matches_waiting();
  picture.num_matches_repeated = state_->mapper.num_matches_repeated();
  MutexLock lock(mutex_);
  picture_ = std::move(picture);
}

MapPicture MappingEngine::Picture() const {
  MutexLock lock(mutex_);
  return picture_;
}

}  // namespace rovio_sfm
