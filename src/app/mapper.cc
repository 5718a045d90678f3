#include "rovio_sfm/app/mapper.h"

#include <utility>

#include "rovio_sfm/mapping/grow_map.h"
#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/update_scale.h"
#include "rovio_sfm/merging/match_across_break.h"
#include "rovio_sfm/merging/share_scales.h"
#include "rovio_sfm/report/collect_model.h"
#include "rovio_sfm/report/measure_odometry_delay.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {

Mapper::Mapper(const MapOptions& options, FrameStore* store, Executor* executor, StageTimes* times,
               ResultTiming timing)
    : options_(options),
      keeper_(options, store, executor, timing, times),
      context_{options,
               store,
               keeper_.LendSessions(),
               executor,
               timing,
               times,
               UpdateOdometryDelay,
               [this](SessionId id) { return keeper_.IsLinked(id); }} {
  std::string error;
  ROVIO_CHECK(IsValid(options, &error), error);
}

void Mapper::Restore(MapStore* store) {
  MapRecord record =
      store->Read({[this](const FrameEvent& event) { return MakeKeyframe(event, {}, options_); },
                   [](const FrameEvent& event) { return MakeLightFrame(event); }});
  keeper_.Restore(std::move(record.sessions), std::move(record.merges));
  for (const DriveRecord& drive : record.drives) {
    const auto read_event = [&](uint32_t index) {
      auto event = store->frames().ReadEvent({drive.id, index}, EventParts::kAll);
      if (event) return *event;
      throw StoreError(store->file() + ": frame " + std::to_string(index) + " of drive " +
                       drive.id.ToString() + " is missing");
    };
    drives_[drive.id] = std::make_unique<DriveMapper>(context_, drive, read_event);
  }
}

bool Mapper::SaveTo(MapStore* store) {
  return store->Commit([&] {
    for (const auto& [id, drive] : drives_) store->frames().PutState(id, drive->State());
    keeper_.PutInto(store);
  });
}

std::map<DriveId, uint32_t> Mapper::NextIndices() const {
  std::map<DriveId, uint32_t> indices;
  for (const auto& [id, drive] : drives_) indices[id] = drive->State().next_index.value_or(0);
  return indices;
}

MapperReport Mapper::Add(const FrameEvent& event) {
  auto& drive = drives_[event.id.drive];
  if (drive == nullptr) {
    drive = std::make_unique<DriveMapper>(context_, event.id.drive, event.camera);
  }
  if (event.kind == FrameKind::kKeyframe) {
    const auto scope = MeasureStage(context_.times, "merge");
    keeper_.CountKeyframe();
  }
  const SessionId started = StartedSession(*drive);
  MapperReport report = drive->Add(event);
  if (report.outcome == MapperOutcome::kHeld) TrySeed(event.id.drive);
  if (!(StartedSession(*drive) == started)) MatchWithLast(StartedSession(*drive));
  if (report.outcome == MapperOutcome::kHeld || report.outcome == MapperOutcome::kKeyframe) {
    const auto scope = MeasureStage(context_.times, "merge");
    keeper_.Advance();
  }
  return report;
}

void Mapper::Add(const PlaceMatch& match) {
  const auto scope = MeasureStage(context_.times, "merge");
  keeper_.Add(match);
}

void Mapper::AddSeeded(const std::vector<FrameEvent>& events,
                       const std::vector<PlaceMatch>& matches) {
  if (events.empty()) return;
  auto& drive = drives_[events.front().id.drive];
  ROVIO_CHECK(drive == nullptr, "the drive is mapped already");
  drive = std::make_unique<DriveMapper>(context_, events.front().id.drive, events.front().camera);
  drive->HoldAll(events);
  if (!matches.empty()) drive->Seed(matches);
  drive->Finish();
  for (const PlaceMatch& match : matches) Add(match);
}

bool Mapper::Rejoin(const FrameEvent& event, const PlaceMatch& place) {
  const Session* session = RejoinFrame(
      event, place, options_, *context_.store, context_.times,
      [this](const Session& of) { return SiblingsOf(of); }, keeper_.LendSessions());
  if (session != nullptr) rejoined_.insert(session->id());
  return session != nullptr;
}

std::vector<Sibling> Mapper::SiblingsOf(const Session& session) const {
  const MapPlace place = keeper_.PlaceOf(session.id());
  std::vector<Sibling> siblings;
  for (const auto& [id, other] : keeper_.sessions().all()) {
    const MapPlace its = keeper_.PlaceOf(id);
    if (id == session.id() || !(other->drive() == session.drive()) || !(its.map == place.map)) {
      continue;
    }
    siblings.push_back({other.get(), Inverse(place.map_from_session) * its.map_from_session});
  }
  return siblings;
}

MergeReport Mapper::Merge(SessionId a, SessionId b, bool force) {
  return keeper_.Merge(a, b, force);
}

MergeReport Mapper::MergeAt(SessionId a, SessionId b, const Sim3& b_from_a) {
  return keeper_.MergeAt(a, b, b_from_a);
}

std::vector<MergeReport> Mapper::Unmerge(SessionId id) { return keeper_.Unmerge(id); }

void Mapper::TrySeed(const DriveId& drive) {
  DriveMapper& mapper = *drives_.at(drive);
  if (!mapper.HoldsFrames(options_.merge.seed_after)) return;
  const std::vector<PlaceMatch> matches = keeper_.WaitingFor(drive);
  if (!matches.empty()) mapper.Seed(matches);
}

// The drive's current session, if it has begun; else none, 0.
SessionId Mapper::StartedSession(const DriveMapper& drive) const {
  const SessionId session = drive.current_session();
  return keeper_.sessions().Find(session)->keyframes().empty() ? SessionId{} : session;
}

// A session that begins where the one before was lost, or ended by an orderly end of the program,
// overlaps with it by the frontend's matches.
void Mapper::MatchWithLast(SessionId session) {
  const Session* after = keeper_.sessions().Find(session);
  if (after == nullptr) return;
  const Session* before = nullptr;
  for (const auto& [id, other] : keeper_.sessions().all()) {
    const bool precedes = id < session && other->drive() == after->drive();
    if (precedes && !other->keyframes().empty()) before = other.get();
  }
  if (before == nullptr) return;
  for (const PlaceMatch& match : MatchAcrossBreak(*before, *after)) Add(match);
}

// Closes the drive's current session, which may begin with that.
void Mapper::FinishDrive(const DriveId& id) {
  DriveMapper& drive = *drives_.at(id);
  const SessionId started = StartedSession(drive);
  TrySeed(id);
  drive.Finish();
  if (!(StartedSession(drive) == started)) MatchWithLast(StartedSession(drive));
}

bool Mapper::FinishSession(const DriveId& drive) {
  const auto it = drives_.find(drive);
  if (it == drives_.end()) return false;
  const SessionId session = it->second->current_session();
  FinishDrive(drive);
  // A drive that began and posed nothing has changed no map.
  if (!keeper_.sessions().all().at(session)->keyframes().empty()) AdjustMaps(session);
  return true;
}

void Mapper::FinishDrives() {
  for (const auto& [id, drive] : drives_) FinishDrive(id);
}

void Mapper::Finish() {
  FinishDrives();
  for (const SessionId id : std::exchange(rejoined_, {})) {
    Session* session = keeper_.LendSessions()->Lend(id);
    if (!keeper_.IsLinked(id)) AdjustWithCamera(options_, session);
    RefineLightFrames(options_, session);
  }
  AdjustMaps(std::nullopt);
  keeper_.GiveUpWaiting();
}

// The maps that links join are adjusted as one, and what hangs on their frames follows.
void Mapper::AdjustMaps(std::optional<SessionId> of) {
  const auto scope = MeasureStage(context_.times, "merge");
  std::map<SessionId, uint64_t> revisions;
  for (const auto& [id, session] : keeper_.sessions().all()) revisions[id] = session->revision();
  keeper_.Advance();
  of ? keeper_.AdjustFinally(*of) : keeper_.AdjustAllFinally();
  for (const auto& [id, revision] : revisions) {
    Session* session = keeper_.LendSessions()->Lend(id);
    if (session->revision() == revision) continue;
    RefineLightFrames(options_, session);
    if (session->state() != SessionState::kMapping) UpdateScale(options_.scale, true, session);
  }
}

std::shared_ptr<const MapSnapshot> Mapper::Snapshot() const {
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->version = ++version_;
  for (const auto& [id, session] : keeper_.sessions().all()) {
    const MapPlace place = keeper_.PlaceOf(id);
    snapshot->sessions.push_back(session->Snapshot());
    snapshot->sessions.back().map = place.map;
    snapshot->sessions.back().map_from_session = place.map_from_session;
    snapshot->sessions.back().gauge_revision = place.revision;
  }
  ShareScales(&snapshot->sessions);
  snapshot->shared_landmarks = keeper_.shared_landmarks();
  return snapshot;
}

MapModel Mapper::ModelOf(const LevelMap& map) const {
  return CollectModel(map, keeper_.sessions(), *context_.store);
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
