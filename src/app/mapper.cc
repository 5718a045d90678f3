#include "rovio_sfm/app/mapper.h"

#include "rovio_sfm/merging/share_scales.h"
#include "rovio_sfm/report/measure_odometry_delay.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

Mapper::Mapper(const MapOptions& options, FrameStore* store, Executor* executor, StageTimes* times)
    : options_(options),
      context_{options,
               store,
               executor,
               times,
               [this] { return SessionId{++num_sessions_}; },
               UpdateOdometryDelay},
      merger_(options, store) {
  std::string error;
  ROVIO_CHECK(options.IsValid(&error), error);
}

MapperReport Mapper::Add(const FrameEvent& event) {
  auto& drive = drives_[event.id.drive];
  if (drive == nullptr) {
    drive = std::make_unique<DriveMapper>(context_, event.id.drive, event.camera);
  }
  MapperReport report = drive->Add(event);
  if (report.outcome == MapperOutcome::kHeld) TrySeed(event.id.drive);
  if (report.outcome == MapperOutcome::kHeld || report.outcome == MapperOutcome::kKeyframe) {
    const auto scope = MeasureStage(context_.times, "merge");
    merger_.Advance(Sessions());
    Settle();
  }
  return report;
}

void Mapper::Add(const PlaceMatch& match) {
  const auto scope = MeasureStage(context_.times, "merge");
  merger_.Add(match, Sessions());
  Settle();
}

void Mapper::AddSeeded(const std::vector<FrameEvent>& events,
                       const std::vector<PlaceMatch>& matches) {
  if (events.empty()) return;
  auto& drive = drives_[events.front().id.drive];
  ROVIO_CHECK(drive == nullptr, "the drive is mapped already");
  drive = std::make_unique<DriveMapper>(context_, events.front().id.drive, events.front().camera);
  drive->HoldAll(events);
  if (!matches.empty()) drive->Seed(matches, Sessions());
  drive->Finish();
  for (const PlaceMatch& match : matches) Add(match);
}

MergeReport Mapper::Merge(SessionId a, SessionId b, bool force) {
  MergeReport report = merger_.Merge(a, b, force, Sessions());
  Settle();
  return report;
}

MergeReport Mapper::MergeAt(SessionId a, SessionId b, const Sim3& b_from_a) {
  MergeReport report = merger_.MergeAt(a, b, b_from_a, Sessions());
  Settle();
  return report;
}

std::vector<MergeReport> Mapper::Unmerge(SessionId id) {
  std::vector<MergeReport> reports = merger_.Unmerge(id, Sessions());
  Settle();
  return reports;
}

void Mapper::TrySeed(const DriveId& drive) {
  DriveMapper& mapper = *drives_.at(drive);
  if (!mapper.HoldsFrames(options_.merge.seed_after)) return;
  const std::vector<PlaceMatch> matches = merger_.WaitingFor(drive);
  if (!matches.empty()) mapper.Seed(matches, Sessions());
}

SessionTable Mapper::Sessions() const {
  SessionTable table;
  for (const auto& [id, drive] : drives_) {
    for (const auto& session : drive->sessions()) table.Add(session.get());
  }
  return table;
}

DriveMapper* Mapper::DriveOf(SessionId id) const {
  for (const auto& [drive_id, drive] : drives_) {
    for (const auto& session : drive->sessions()) {
      if (session->id() == id) return drive.get();
    }
  }
  return nullptr;
}

// Tells the drives whose sessions merging has changed.
void Mapper::Settle() {
  for (const SessionId id : merger_.TakeChanged()) DriveOf(id)->OnSessionChanged(id);
}

bool Mapper::FinishSession(const DriveId& drive) {
  const auto it = drives_.find(drive);
  if (it == drives_.end()) return false;
  TrySeed(drive);
  it->second->Finish();
  AdjustMaps();
  return true;
}

void Mapper::Finish() {
  for (const auto& [id, drive] : drives_) {
    TrySeed(id);
    drive->Finish();
  }
  AdjustMaps();
  merger_.GiveUpWaiting();
}

// A session's own final adjustment knows nothing of the others: the maps they share are adjusted
// once more, together.
void Mapper::AdjustMaps() {
  const auto scope = MeasureStage(context_.times, "merge");
  const SessionTable sessions = Sessions();
  merger_.Advance(sessions);
  merger_.AdjustFinally(sessions);
  for (const SessionId id : merger_.TakeChanged()) {
    DriveOf(id)->OnSessionChanged(id);
    RefineLightFrames(options_, sessions.Find(id));
  }
}

std::shared_ptr<const MapSnapshot> Mapper::Snapshot() const {
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->version = ++version_;
  const SessionTable sessions = Sessions();
  for (const auto& [id, session] : sessions.all()) {
    const MapPlace place = merger_.PlaceOf(id);
    snapshot->sessions.push_back(session->Snapshot());
    snapshot->sessions.back().map = place.map;
    snapshot->sessions.back().map_from_session = place.map_from_session;
    snapshot->sessions.back().gauge_revision = place.revision;
  }
  ShareScales(&snapshot->sessions);
  snapshot->shared_landmarks = merger_.shared_landmarks();
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
