#include "rovio_sfm/app/mapping_engine.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

std::vector<FrameId> NewestFrames(const std::map<DriveId, uint32_t>& next_indices) {
  std::vector<FrameId> newest;
  for (const auto& [drive, next_index] : next_indices) {
    if (next_index > 0) newest.push_back({drive, next_index - 1});
  }
  return newest;
}

}  // namespace

FrameSnapshot FrameOf(const Localization& pose) {
  FrameSnapshot frame;
  frame.index = pose.id.index;
  frame.stamp_ns = pose.stamp_ns;
  frame.image_name = pose.image_name;
  frame.kind = FrameKind::kLight;
  frame.cam_from_session = pose.cam_from_session;
  frame.base_from_camera = pose.base_from_camera;
  frame.num_observations = pose.num_inliers;
  return frame;
}

const FrameSnapshot* FindAnchorFrame(const SessionSnapshot& session, const OdometryAnchor& anchor) {
  if (anchor.localized) return &*anchor.localized;
  return FindFrame(session, anchor.index);
}

std::vector<std::string> WhyNotMetric(const MapPicture& picture) {
  std::set<std::string> posed, metric;
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    if (!session.frames.empty()) posed.insert(session.drive.robot);
    if (session.scale) metric.insert(session.drive.robot);
  }
  std::vector<std::string> sentences;
  for (const auto& [robot, counts] : picture.motion) {
    if (posed.count(robot) == 0 || metric.count(robot) > 0) continue;
    sentences.push_back(robot + ": " + WhyNoScale(counts));
  }
  return sentences;
}

MappingEngine::MappingEngine(const MapOptions& options, std::unique_ptr<StoreFolder> store)
    : options_(options),
      store_(std::move(store)),
      state_(std::make_unique<State>(options, store_ ? &store_->store() : nullptr)) {
  if (store_) Resume();
  if (store_ && !store_->IsWritten()) state_->localizer.emplace(options_, &state_->mapper.maps());
  Show();
}

// A robot's newest drive may go on; those before it have ended.
void MappingEngine::Resume() {
  state_->mapper.Restore(&store_->store());
  for (const DriveRecord& record : store_->store().frames().ReadDrives()) {
    const DriveId& drive = record.id;
    const uint32_t next_index = record.state.next_index.value_or(0);
    const auto older = current_drives_.find(drive.robot);
    if (older != current_drives_.end()) ended_drives_.insert(older->second);
    current_drives_[drive.robot] = drive;
    next_indices_[drive] = next_index;
  }
  saved_up_to_ = NewestFrames(state_->mapper.NextIndices());
}

void MappingEngine::Save() {
  if (!store_ || is_saved_ || localizes()) return;
  if (state_->mapper.SaveTo(&store_->store())) {
    saved_up_to_ = NewestFrames(state_->mapper.NextIndices());
  }
  Show();
  is_saved_ = true;  // showing changed nothing
}

MapperReport MappingEngine::Add(const FrameEvent& event) {
  ++num_events_;
  MapperReport report;
  report.outcome = MapperOutcome::kRefused;
  if (!EnterDrive(event.id.drive, &report.reason)) return report;
  next_indices_[event.id.drive] = event.id.index + 1;
  report = state_->mapper.Add(event);
  CountMotion(event, &motion_[event.id.drive.robot]);
  const bool is_registered =
      report.outcome == MapperOutcome::kKeyframe || report.outcome == MapperOutcome::kLight;
  if (is_registered) {
    Anchor({report.session, event.id.index, event.odometry, event.id.drive});
  }
  Show();
  return report;
}

void MappingEngine::Add(const PlaceMatch& match) {
  ++num_place_matches_;
  state_->mapper.Add(match);
  Show();
}

std::optional<Localization> MappingEngine::Localize(const FrameEvent& event) {
  ++num_events_;
  next_indices_[event.id.drive] = event.id.index + 1;
  std::optional<Localization> pose = state_->localizer->Add(event);
  astray_.insert(event.id.drive.robot);
  if (pose) Anchor(*pose);
  Show();
  return pose;
}

std::optional<Localization> MappingEngine::Localize(const PlaceMatch& match) {
  ++num_place_matches_;
  std::optional<Localization> pose = state_->localizer->Add(match);
  if (pose) Anchor(*pose);
  Show();
  return pose;
}

// A robot stays where its newest frame put it.
void MappingEngine::Anchor(const OdometryAnchor& newer) {
  anchors_[newer.drive.robot] = newer;
  if (newer.odometry) wheel_anchors_[newer.drive.robot] = newer;
}

void MappingEngine::Anchor(const Localization& pose) {
  const DriveId& drive = pose.id.drive;
  const auto anchor = anchors_.find(drive.robot);
  if (anchor != anchors_.end() && anchor->second.drive == drive && anchor->second.localized &&
      anchor->second.localized->stamp_ns > pose.stamp_ns) {
    return;
  }
  astray_.erase(drive.robot);
  Anchor({pose.session, pose.id.index, pose.odometry, drive, FrameOf(pose)});
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
  if (localizes()) return;
  state_->mapper.Finish();
  Show();
  Save();
}

std::filesystem::path MappingEngine::Reset() {
  Save();
  state_.reset();
  std::filesystem::path aside;
  if (store_) aside = store_->StartAnew();
  BeginAnew();
  Show();
  return aside;
}

std::filesystem::path MappingEngine::Load(const std::filesystem::path& other) {
  ROVIO_CHECK(store_ != nullptr, "no store is kept");
  MapStore(other, StoreAccess::kRead);  // throws while nothing is lost
  Save();
  state_.reset();
  const std::filesystem::path aside = store_->GoOnWith(other);
  BeginAnew();
  const std::map<std::string, DriveId> running = std::exchange(current_drives_, {});
  Resume();
  for (const auto& [robot, drive] : running) {  // what is under way is newer than what was loaded
    const auto loaded = current_drives_.find(robot);
    if (loaded != current_drives_.end()) ended_drives_.insert(loaded->second);
    ended_drives_.erase(drive);
    current_drives_[robot] = drive;
  }
  Show();
  return aside;
}

void MappingEngine::BeginAnew() {
  state_ = std::make_unique<State>(options_, store_ ? &store_->store() : nullptr);
  anchors_.clear();
  wheel_anchors_.clear();
  astray_.clear();
  saved_up_to_.clear();
  ++epoch_;
}

void MappingEngine::Show() {
  is_saved_ = false;
  MapPicture picture = Picture();
  ++picture.number;
  picture.epoch = epoch_;
  picture.snapshot = state_->mapper.Snapshot();
  picture.anchors = anchors_;
  picture.wheel_anchors = wheel_anchors_;
  picture.motion = motion_;
  picture.counters = state_->mapper.counters();
  picture.num_events = num_events_;
  std::vector<MergeReport> merges = state_->mapper.MergeReports();
  if (!(merges == *picture.merges)) {
    picture.merges = std::make_shared<const std::vector<MergeReport>>(std::move(merges));
  }
  picture.num_place_matches = num_place_matches_;
  picture.num_matches_waiting = state_->mapper.num_matches_waiting();
  picture.num_matches_repeated = state_->mapper.num_matches_repeated();
  if (localizes()) {
    picture.num_localized = state_->localizer->num_posed();
    picture.num_not_localized = state_->localizer->num_frames() - picture.num_localized;
    picture.astray = astray_;
  }
  picture.saved_up_to = saved_up_to_;
  if (store_) picture.store_error = store_->store().error();
  MutexLock lock(mutex_);
  picture_ = std::move(picture);
}

MapPicture MappingEngine::Picture() const {
  MutexLock lock(mutex_);
  return picture_;
}

}  // namespace rovio_sfm
