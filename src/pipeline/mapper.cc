#include "rovio_sfm/pipeline/mapper.h"

#include <algorithm>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

Mapper::Mapper(const MapperOptions& options, FrameStore* store, Executor* executor,
               StageTimes* times)
    : context_{options, store, executor, times, [this] { return SessionId{++num_sessions_}; }} {
  std::string error;
  ROVIO_CHECK(options.IsValid(&error), error);
}

MapperReport Mapper::Add(const FrameEvent& event) {
  auto& drive = drives_[event.id.drive];
  if (drive == nullptr) {
    drive = std::make_unique<DriveMapper>(context_, event.id.drive, event.camera);
  }
  return drive->Add(event);
}

bool Mapper::FinishSession(const DriveId& drive) {
  const auto it = drives_.find(drive);
  if (it == drives_.end()) return false;
  it->second->Finish();
  return true;
}

void Mapper::Finish() {
  for (const auto& [id, drive] : drives_) drive->Finish();
}

std::shared_ptr<const MapSnapshot> Mapper::Snapshot() const {
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->version = ++version_;
  for (const auto& [id, drive] : drives_) {
    for (const auto& session : drive->sessions()) snapshot->sessions.push_back(session->Snapshot());
  }
  std::sort(snapshot->sessions.begin(), snapshot->sessions.end(),
            [](const SessionSnapshot& a, const SessionSnapshot& b) { return a.id < b.id; });
  return snapshot;
}

MapperCounters Mapper::counters() const {
  MapperCounters total;
  for (const auto& [id, drive] : drives_) {
    const MapperCounters& counters = drive->counters();
    total.keyframes += counters.keyframes;
    total.light_frames += counters.light_frames;
    total.weak_frames += counters.weak_frames;
    total.missing_events += counters.missing_events;
    total.refused_events += counters.refused_events;
    total.lost_sessions += counters.lost_sessions;
    total.global_adjustments += counters.global_adjustments;
  }
  return total;
}

}  // namespace rovio_sfm
