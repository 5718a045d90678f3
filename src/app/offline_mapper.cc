#include "rovio_sfm/app/offline_mapper.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/app/wait_for_end.h"
#include "rovio_sfm/util/checksum.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMappingQueue = 4;       // events; the frontend waits where mapping is behind
constexpr size_t kPreparedPerThread = 4;  // images ahead of the frontend
constexpr size_t kFramesPerCommit = 10;
constexpr size_t kMaxNewestBytes = 64u << 20;
constexpr int kRejoinRounds = 4;

void Add(const FrontendCounters& more, FrontendCounters* sum) {
  sum->images += more.images;
  sum->refused += more.refused;
  sum->late += more.late;
  sum->spoilt += more.spoilt;
  sum->featureless += more.featureless;
  sum->untracked += more.untracked;
  sum->keyframes += more.keyframes;
  sum->light_frames += more.light_frames;
  sum->drives += more.drives;
  sum->links += more.links;
  sum->track_matches += more.track_matches;
  sum->refused_f1 += more.refused_f1;
}

uint64_t NumDropped(const FrontendCounters& counters) {
  return counters.refused + counters.spoilt + counters.featureless + counters.untracked;
}

bool IsHeld(const FrameId& id, const SessionTable& sessions) {
  for (const auto& [session_id, session] : sessions.all()) {
    if (!(session->drive() == id.drive)) continue;
    if (session->keyframes().count(id.index) + session->light_frames().count(id.index) > 0) {
      return true;
    }
  }
  return false;
}

// The other half is for adjusting and writing.
bool HasTimeToMap() { return SecondsSinceStop().value_or(0.0) < kEndBudgetS / 2; }

}  // namespace

OfflineMapper::OfflineMapper(const OfflineMapperOptions& options,
                             std::shared_ptr<const PlaceModel> place_model, StageTimes* times,
                             MapStore* store)
    : options_(options),
      times_(times),
      kept_(store),
      newest_(kMaxNewestBytes,
              [store](const FrameId& id) { return store == nullptr ? nullptr : store->Get(id); }),
      store_(ChooseStore()),
      adjust_executor_(options.num_threads > 1 ? 1 : 0),
      prepare_executor_(options.num_threads - 1),
      prepared_(&prepare_executor_),
      mapper_(options.mapper, store_, &adjust_executor_, times) {
  if (place_model) recognizer_.emplace(options.places, std::move(place_model), store_, times);
  if (kept_ != nullptr) Resume();
  if (options.localize) localizer_.emplace(options.mapper, &mapper_.maps());
  if (options.num_threads == 1) return;
  mapping_ = std::make_unique<Worker<FrameEvent>>(kMappingQueue, WhenFull::kBlock,
                                                  [this](const FrameEvent& event) { Map(event); });
}

FrameStore* OfflineMapper::ChooseStore() {
  if (options_.localize) return &newest_;
  return kept_ == nullptr ? static_cast<FrameStore*>(&memory_) : kept_;
}

// Places of the frames that are there are known again; what they match was judged before.
void OfflineMapper::Resume() {
  mapper_.Restore(kept_);
  kept_before_ = mapper_.NextIndices();
  for (const auto& [id, session] : mapper_.maps().sessions().all()) {
    if (!session->keyframes().empty()) newest_sessions_[session->drive()] = id;
  }
  if (!recognizer_) return;
  for (const auto& [drive, next_index] : kept_before_) {
    for (const uint32_t index : kept_->frames().ReadIndices(drive)) {
      const auto event = kept_->frames().ReadEvent({drive, index}, EventParts::kAll);
      if (event) recognizer_->Add(*event);
    }
  }
  recognizer_->ResetCounters();
}

// What is only localised is never a drive of the maps, though it began with the same picture. Of
// what is mapped, folders are named by their place in the command, which may be another today. The
// same pictures given twice are two drives.
DriveId OfflineMapper::NameOf(const DriveId& drive) const {
  DriveId name = drive;
  if (!localizer_ && kept_before_.count(drive) == 0) {
    for (const auto& [kept, next_index] : kept_before_) {
      const bool is_same = kept.start_ns == drive.start_ns && kept.nonce == drive.nonce;
      if (is_same && start_of_drive_.count(kept) == 0) name = kept;
    }
  }
  const auto is_taken = [&] {
    return start_of_drive_.count(name) > 0 || (localizer_ && kept_before_.count(name) > 0);
  };
  while (is_taken()) ++name.nonce;
  return name;
}

void OfflineMapper::StartDrive(const std::string& robot) {
  FinishDrive();
  robot_ = robot;
  names_.clear();
  ++num_starts_;
}

void OfflineMapper::Add(ImageEvent image) {
  ROVIO_CHECK(num_starts_ > 0, "StartDrive comes before Add");
  if (!frontend_) {
    const uint32_t nonce = Checksum(image.encoded->data(), image.encoded->size());
    frontend_.emplace(options_.frontend, robot_, options_.seed, nonce, times_);
  }
  const size_t max_ahead = kPreparedPerThread * static_cast<size_t>(options_.num_threads - 1);
  prepared_.Add([image = std::move(image), &options = options_.frontend, times = times_] {
    const auto scope = MeasureStage(times, "prepare");
    return PrepareImage(image, options);
  });
  while (prepared_.NumPending() > max_ahead) TakeOldest();
}

void OfflineMapper::TakeOldest() {
  const PreparedImage image = prepared_.TakeNext();
  const uint64_t num_dropped = NumDropped(frontend_->counters());
  std::optional<FrameEvent> event = frontend_->Add(image);
  if (NumDropped(frontend_->counters()) > num_dropped) {
    CountReason(frontend_->last_refusal(), &dropped_);
  }
  if (!event) return;
  const auto [name, is_new] = names_.try_emplace(event->id.drive);
  if (is_new) name->second = NameOf(event->id.drive);
  event->id.drive = name->second;
  start_of_drive_.emplace(event->id.drive, num_starts_ - 1);
  AddToFunnel(*event, &funnel_);
  CountMotion(*event, &motion_);
  if (mapping_) {
    mapping_->Push(std::move(*event));
  } else {
    Map(*event);
  }
}

void OfflineMapper::Map(const FrameEvent& event) {
  if (options_.seeded) {
    const bool is_new = drives_.empty() || drives_.back().front().id.drive != event.id.drive;
    if (is_new) drives_.emplace_back();
    drives_.back().push_back(event);
    return;
  }
  if (localizer_) return Localize(event);
  if (IsKept(event)) return;
  const MapperReport report = mapper_.Add(event);
  landmarks_.created += report.growth.num_created;
  landmarks_.united += report.growth.num_united;
  landmarks_.pruned_observations += report.growth.num_pruned;
  if (report.outcome == MapperOutcome::kRefused) CountReason("frame: " + report.reason, &refused_);
  if (recognizer_) {
    const auto [session, is_new] = newest_sessions_.try_emplace(event.id.drive, report.session);
    if (!is_new && !(session->second == report.session)) {
      const int num_weak = options_.mapper.max_weak_frames;  // that the next session begins with
      recognizer_->EndRecentPast(event.id.drive, static_cast<size_t>(num_weak));
    }
    session->second = report.session;
    for (const PlaceMatch& match : recognizer_->Add(event)) mapper_.Add(match);
  }
  if (kept_ == nullptr || kept_->num_uncommitted() < kFramesPerCommit) return;
  const auto scope = MeasureStage(times_, "store");
  mapper_.SaveTo(kept_);
}

// Whether the store has the frame, or other pictures of its drive, by other options: they would be
// mapped twice.
bool OfflineMapper::IsKept(const FrameEvent& event) {
  const DriveId& drive = event.id.drive;
  const auto kept = kept_before_.find(drive);
  if (kept == kept_before_.end()) return false;
  const bool is_there = event.id.index < kept->second;
  if (is_there && otherwise_kept_.count(drive) == 0) {
    const auto there = kept_->frames().ReadEvent(event.id, EventParts::kBare);
    if (there && there->stamp_ns != event.stamp_ns) otherwise_kept_.insert(drive);
  }
  if (otherwise_kept_.count(drive) == 0) return is_there;
  CountReason(
      "frame: the map holds another picture of its drive under its number; stride, "
      "mode and the options of the frontend must be those of the run before",
      &refused_);
  return true;
}

// Frames between sessions, and those that tracking dropped, once all that may show their places is
// mapped. The light ones, on which nothing hangs, come last: when the landmarks are at rest.
void OfflineMapper::RejoinLost(FrameKind kind) {
  if (kept_ == nullptr) return;
  for (const auto& [drive, next_index] : mapper_.NextIndices()) {
    const auto kept = kept_before_.find(drive);
    if (kept != kept_before_.end() && kept->second == next_index) continue;
    std::vector<uint32_t> lost;
    for (const uint32_t index : kept_->frames().ReadIndices(drive)) {
      if (!IsHeld({drive, index}, mapper_.maps().sessions())) lost.push_back(index);
    }
    RejoinLost(kind, drive, lost);
  }
}

// In rounds until none joins, as each keyframe that does brings landmarks that others may show.
void OfflineMapper::RejoinLost(FrameKind kind, const DriveId& drive, std::vector<uint32_t> lost) {
  std::map<uint32_t, PlaceMatch> places;
  if (kind == FrameKind::kKeyframe) places = PlacesOf(lost, drive);
  const size_t num_lost = lost.size();
  size_t num_before = num_lost + 1;
  for (int round = 0; round < kRejoinRounds && lost.size() < num_before && HasTimeToMap();
       ++round) {
    num_before = lost.size();
    const auto joins = [&](uint32_t index) {
      const auto event = kept_->frames().ReadEvent({drive, index}, EventParts::kBare);
      return event && event->kind == kind && mapper_.Rejoin(*event, places[index]);
    };
    lost.erase(std::remove_if(lost.begin(), lost.end(), joins), lost.end());
  }
  num_rejoined_ += num_lost - lost.size();
}

// Where the keyframes among them match posed ones of their drive, by index.
std::map<uint32_t, PlaceMatch> OfflineMapper::PlacesOf(const std::vector<uint32_t>& lost,
                                                       const DriveId& drive) {
  std::map<uint32_t, PlaceMatch> places;
  if (!recognizer_) return places;
  std::vector<FrameId> posed;
  for (const auto& [id, session] : mapper_.maps().sessions().all()) {
    for (const auto& [index, frame] : session->keyframes()) {
      if (session->drive() == drive && !frame.weak) posed.push_back({drive, index});
    }
  }
  for (const uint32_t index : lost) {
    if (!HasTimeToMap()) break;
    for (PlaceMatch& match : recognizer_->FindOverlaps({{drive, index}}, posed)) {
      places.emplace(index, std::move(match));
    }
  }
  return places;
}

void OfflineMapper::Localize(const FrameEvent& event) {
  store_->Put(event);
  KeepBest(localizer_->Add(event));
  if (!recognizer_) return;
  for (const PlaceMatch& match : recognizer_->Add(event)) KeepBest(localizer_->Add(match));
}

void OfflineMapper::KeepBest(const std::optional<Localization>& pose) {
  if (!pose) return;
  Localization& best = localizations_[pose->id];
  if (pose->num_inliers > best.num_inliers) best = *pose;
}

// A match's query is the later frame: by query, the thesis's table T is inverted.
void OfflineMapper::MapSeeded() {
  const std::vector<std::vector<FrameEvent>> drives = std::exchange(drives_, {});
  std::vector<std::vector<PlaceMatch>> matches(drives.size());
  for (size_t i = 0; i < drives.size() && recognizer_; ++i) {
    for (const FrameEvent& event : drives[i]) {
      if (!HasTimeToMap()) break;
      store_->Put(event);
      for (PlaceMatch& match : recognizer_->Add(event)) matches[i].push_back(std::move(match));
    }
  }
  for (size_t i = 0; i < drives.size() && (i == 0 || HasTimeToMap()); ++i) {
    if (i == 0) {
      MapFirst(drives[i], matches[i]);
    } else {
      mapper_.AddSeeded(drives[i], matches[i]);
    }
  }
}

void OfflineMapper::MapFirst(const std::vector<FrameEvent>& events,
                             const std::vector<PlaceMatch>& matches) {
  for (const FrameEvent& event : events) {
    if (!HasTimeToMap()) return;
    mapper_.Add(event);
  }
  for (const PlaceMatch& match : matches) mapper_.Add(match);
  mapper_.FinishSession(events.front().id.drive);
}

void OfflineMapper::FinishDrive() {
  if (!frontend_) return;
  while (prepared_.NumPending() > 0) TakeOldest();
  rovio_sfm::Add(frontend_->counters(), &frontend_counters_);
  frontend_.reset();
}

ReasonCounts OfflineMapper::reasons() const {
  ReasonCounts all = dropped_;
  AddReasons(refused_, &all);
  return all;
}

std::shared_ptr<const MapSnapshot> OfflineMapper::Drain() {
  FinishDrive();
  if (mapping_) mapping_->Finish();
  if (options_.seeded && !localizer_) MapSeeded();
  if (kept_ != nullptr && !localizer_) mapper_.SaveTo(kept_);
  return mapper_.Snapshot();
}

std::shared_ptr<const MapSnapshot> OfflineMapper::Finish() {
  const std::shared_ptr<const MapSnapshot> drained = Drain();
  if (localizer_) return drained;
  mapper_.FinishDrives();
  RejoinLost(FrameKind::kKeyframe);
  mapper_.Finish();
  RejoinLost(FrameKind::kLight);
  if (kept_ != nullptr) mapper_.SaveTo(kept_);
  return mapper_.Snapshot();
}

}  // namespace rovio_sfm
