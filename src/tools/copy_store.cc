#include "rovio_sfm/tools/copy_store.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/mapping/make_keyframe.h"

namespace rovio_sfm {
namespace {

constexpr size_t kFramesPerCommit = 50;

// A target that goes again where it could not be filled.
class NewStore {
 public:
  explicit NewStore(const std::filesystem::path& path) : path_(path) {
    if (std::filesystem::exists(path)) {
      throw StoreError(path.string() + ": not overwritten: file exists");
    }
    lock_ = LockStoreFile(path);
    store_ = std::make_unique<MapStore>(path, StoreAccess::kCreate);
  }
  ~NewStore() {
    store_.reset();
    std::error_code ignored;
    if (!is_complete_) std::filesystem::remove(path_, ignored);
  }
  NewStore(const NewStore&) = delete;
  NewStore& operator=(const NewStore&) = delete;

  void Commit(const std::function<void()>& put) {
    if (!store_->Commit(put)) throw StoreError(store_->error());
  }
  void Complete() { is_complete_ = true; }
  MapStore& store() { return *store_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<MapStore> store_;
  bool is_complete_ = false;
};

// What of a store reads, for a store in which numbers up to these are taken.
struct Shift {
  uint32_t sessions = 0, edits = 0, accepted = 0;

  SessionId operator()(SessionId id) const {
    return {id.value == 0 ? 0 : id.value + sessions};  // 0: none
  }
};

void ShiftEdit(const Shift& shift, MergeEdit* edit) {
  edit->report.id += shift.edits;
  if (edit->sequence != 0) edit->sequence += shift.accepted;
  edit->report.query_session = shift(edit->report.query_session);
  edit->report.other_session = shift(edit->report.other_session);
  std::vector<FeatureLink> links = edit->links.List();
  for (FeatureLink& link : links) {
    link.a.session = shift(link.a.session);
    link.b.session = shift(link.b.session);
  }
  edit->links = links;
  std::map<SessionId, uint32_t> marks;
  for (const auto& [session, mark] : edit->marks) marks[shift(session)] = mark;
  edit->marks = std::move(marks);
}

void ShiftMaps(const Shift& shift, MapRecord* maps) {
  for (SessionRecord& session : maps->sessions) session.id = shift(session.id);
  for (MergeEdit& edit : maps->merges.edits) ShiftEdit(shift, &edit);
  std::map<MapId, uint32_t> revisions;
  for (const auto& [map, revision] : maps->merges.revisions) {
    revisions[{map.value + shift.sessions}] = revision;
  }
  maps->merges.revisions = std::move(revisions);
  std::set<std::pair<SessionId, SessionId>> separated;
  for (const auto& [a, b] : maps->merges.separated) separated.emplace(shift(a), shift(b));
  maps->merges.separated = std::move(separated);
}

// The numbers that maps take.
Shift NumbersOf(const MapRecord& maps) {
  Shift taken;
  for (const SessionRecord& session : maps.sessions) {
    taken.sessions = std::max(taken.sessions, session.id.value);
  }
  taken.edits = static_cast<uint32_t>(maps.merges.edits.size());
  taken.accepted = maps.merges.num_accepted;
  return taken;
}

void AppendMaps(MapRecord more, MapRecord* maps) {
  std::move(more.drives.begin(), more.drives.end(), std::back_inserter(maps->drives));
  std::move(more.sessions.begin(), more.sessions.end(), std::back_inserter(maps->sessions));
  MergeRecord& merges = maps->merges;
  std::move(more.merges.edits.begin(), more.merges.edits.end(), std::back_inserter(merges.edits));
  merges.num_accepted += more.merges.num_accepted;
  merges.revisions.insert(more.merges.revisions.begin(), more.merges.revisions.end());
  merges.separated.insert(more.merges.separated.begin(), more.merges.separated.end());
  std::move(more.merges.waiting.begin(), more.merges.waiting.end(),
            std::back_inserter(merges.waiting));
}

// Frames are put in groups: none of them must stay in memory.
void CopyFrames(const DriveId& drive, MapStore* from, NewStore* to, StoreCopyReport* report) {
  for (const uint32_t index : from->frames().ReadIndices(drive)) {
    try {
      const auto event = from->frames().ReadEvent({drive, index}, EventParts::kAll);
      if (!event) throw StoreError(from->file() + ": is missing");
      to->store().Put(*event);
      ++report->num_frames;
    } catch (const StoreError& error) {
      report->lost.push_back("frame " + FrameId{drive, index}.ToString() + ": " + error.what());
    }
    if (to->store().num_uncommitted() >= kFramesPerCommit) to->Commit([] {});
  }
}

void PutMaps(const MapRecord& maps, NewStore* to) {
  MapStore& store = to->store();
  to->Commit([&] {
    for (const DriveRecord& drive : maps.drives) store.frames().PutState(drive.id, drive.state);
    for (const SessionRecord& record : maps.sessions) {
      Session session(record);
      store.sessions().Put(&session);
    }
    const MergeRecord& merges = maps.merges;
    store.merges().PutEdits({merges.edits.begin(), merges.edits.end()});
    store.merges().PutGauges(merges.num_accepted, merges.revisions, merges.separated);
    store.merges().PutWaiting(merges.waiting);
  });
}

StoreCopyReport ReportOf(const MapRecord& maps) {
  StoreCopyReport report;
  report.num_sessions = maps.sessions.size();
  report.num_edits = maps.merges.edits.size();
  return report;
}

// Sessions that contradict themselves would be refused by whoever goes on with them.
void DropContradictions(MapRecord* maps, std::vector<std::string>* lost) {
  std::vector<SessionRecord> sound;
  for (SessionRecord& record : maps->sessions) {
    const std::string contradiction = CheckInvariants(Session(record));
    if (contradiction.empty()) {
      sound.push_back(std::move(record));
    } else {
      lost->push_back("session " + std::to_string(record.id.value) + ": " + contradiction);
    }
  }
  maps->sessions = std::move(sound);
}

void UndoStrayEdits(MergeRecord* merges, const std::set<SessionId>& kept) {
  const auto is_kept = [&](SessionId id) { return id.value == 0 || kept.count(id) != 0; };
  for (MergeEdit& edit : merges->edits) {
    if (is_kept(edit.report.query_session) && is_kept(edit.report.other_session)) continue;
    edit.report.verdict = MergeVerdict::kUndone;
    edit.report.reason = "one of its sessions could not be read";
    edit.links = {};
    edit.marks.clear();
  }
  for (auto it = merges->separated.begin(); it != merges->separated.end();) {
    it = is_kept(it->first) && is_kept(it->second) ? std::next(it) : merges->separated.erase(it);
  }
}

// What waits for a frame or session that is lost waits in vain.
void ForgetLost(const StoredFrames& frames, DriveRecord* drive) {
  DriveState& state = drive->state;
  state.weak.clear();
  state.unposed.clear();
  state.pending_links.clear();
  const auto is_lost = [&](uint32_t index) {
    return !frames.ReadEvent({drive->id, index}, EventParts::kBare);
  };
  state.held.erase(std::remove_if(state.held.begin(), state.held.end(), is_lost), state.held.end());
}

MapRecord ReadWhatReads(MapStore* store, std::vector<std::string>* lost) {
  MapRecord maps;
  maps.drives = store->frames().ReadDrives();
  maps.sessions = store->sessions().Read(DefaultFrameMaker(), lost);
  DropContradictions(&maps, lost);
  try {
    maps.merges = WithFileNamed(store->file(), [&] { return store->merges().Read(); });
  } catch (const StoreError& error) {
    lost->push_back(std::string("all merges: ") + error.what());
  }
  std::set<SessionId> kept;
  for (const SessionRecord& session : maps.sessions) kept.insert(session.id);
  UndoStrayEdits(&maps.merges, kept);
  return maps;
}

}  // namespace

FrameMaker DefaultFrameMaker() {
  return {[](const FrameEvent& event) { return MakeKeyframe(event, {}, MapperOptions()); },
          [](const FrameEvent& event) { return MakeLightFrame(event); }};
}

StoreCopyReport RepairStore(const std::filesystem::path& from, const std::filesystem::path& to) {
  MapStore source(from, StoreAccess::kRead);
  NewStore target(to);
  std::vector<std::string> lost;
  MapRecord maps = ReadWhatReads(&source, &lost);
  StoreCopyReport report = ReportOf(maps);
  report.lost = std::move(lost);
  for (const DriveRecord& drive : maps.drives) CopyFrames(drive.id, &source, &target, &report);
  if (!report.lost.empty()) {
    for (DriveRecord& drive : maps.drives) ForgetLost(target.store().frames(), &drive);
  }
  PutMaps(maps, &target);
  target.Complete();
  return report;
}

StoreCopyReport MergeStores(const std::filesystem::path& first, const std::filesystem::path& second,
                            const std::filesystem::path& to) {
  MapStore a(first, StoreAccess::kRead), b(second, StoreAccess::kRead);
  MapRecord maps = a.Read(DefaultFrameMaker());
  MapRecord more = b.Read(DefaultFrameMaker());
  for (const DriveRecord& drive : more.drives) {
    if (!a.frames().FindRow(drive.id)) continue;
    throw StoreError(first.string() + " and " + second.string() + ": both hold frames of drive " +
                     drive.id.ToString() + "; expected different drives");
  }
  NewStore target(to);
  ShiftMaps(NumbersOf(maps), &more);
  const size_t num_of_a = maps.drives.size();
  AppendMaps(std::move(more), &maps);
  StoreCopyReport report = ReportOf(maps);
  for (size_t i = 0; i < maps.drives.size(); ++i) {
    CopyFrames(maps.drives[i].id, i < num_of_a ? &a : &b, &target, &report);
  }
  if (!report.lost.empty()) throw StoreError(report.lost.front());
  PutMaps(maps, &target);
  target.Complete();
  return report;
}

}  // namespace rovio_sfm
