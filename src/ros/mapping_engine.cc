#include "rovio_sfm/ros/mapping_engine.h"

#include <algorithm>
#include <utility>

namespace rovio_sfm {

MappingEngine::MappingEngine(const MapperOptions& options)
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

bool MappingEngine::FinishSession(const std::string& robot) {
  const auto drive = current_drives_.find(robot);
  if (drive == current_drives_.end() || !state_->mapper.FinishSession(drive->second)) return false;
  Show();
  return true;
}

void MappingEngine::Finish() {
  state_->mapper.Finish();
  Show();
}

void MappingEngine::Reset() {
  state_.reset();
  state_ = std::make_unique<State>(options_);
  anchors_.clear();
  Show();
}

void MappingEngine::Show() {
  MapPicture picture;
  picture.snapshot = state_->mapper.Snapshot();
  picture.anchors = anchors_;
  picture.counters = state_->mapper.counters();
  picture.num_events = num_events_;
  MutexLock lock(mutex_);
  picture_ = std::move(picture);
}

MapPicture MappingEngine::Picture() const {
  MutexLock lock(mutex_);
  return picture_;
}

}  // namespace rovio_sfm
