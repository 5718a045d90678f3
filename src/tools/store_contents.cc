#include "rovio_sfm/tools/store_contents.h"

#include <iomanip>
#include <map>
#include <memory>
#include <ostream>

#include "rovio_sfm/app/mapper.h"
#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/io/map_store_schema.h"
#include "rovio_sfm/tools/copy_store.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

const char* NameOf(SessionState state) {
  switch (state) {
    case SessionState::kBootstrapping:
      return "bootstrapping";
    case SessionState::kMapping:
      return "mapping";
    case SessionState::kFinished:
      return "finished";
    case SessionState::kLost:
      return "lost";
  }
  return "unknown";
}

void TellDrives(const StoredFrames& frames, std::ostream& out) {
  const std::vector<DriveRecord> drives = frames.ReadDrives();
  out << "drives    " << drives.size() << "\n";
  for (const DriveRecord& drive : drives) {
    const MapperCounters& counters = drive.state.counters;
    out << "  " << drive.id.ToString() << ": "
        << CountText(frames.ReadIndices(drive.id).size(), "frame") << ", of them "
        << CountText(counters.keyframes, "keyframe") << " and "
        << CountText(counters.light_frames, "light frame") << " in a map; goes on at "
        << drive.state.next_index.value_or(0) << "\n";
  }
}

template <typename Block>
size_t CountIn(const std::vector<Block>& blocks) {
  size_t count = 0;
  for (const auto& block : blocks) count += block->size();
  return count;
}

void TellSession(const SessionSnapshot& session, std::ostream& out) {
  out << "  " << session.id.value << ": map " << session.map.value << ", drive "
      << session.drive.ToString() << ", " << NameOf(session.state) << ", "
      << CountText(CountIn(session.frames), "posed frame") << ", "
      << CountText(CountIn(session.landmarks), "landmark");
  if (session.scale) out << ", " << session.scale->metres_per_unit << " m a unit";
  out << "\n";
}

// A map has posed frames, as in summary.json: a session that never began is none.
void TellMaps(const Mapper& mapper, std::ostream& out) {
  const auto snapshot = mapper.Snapshot();
  std::map<MapId, std::string> maps;
  out << "sessions  " << snapshot->sessions.size() << "\n";
  for (const SessionSnapshot& session : snapshot->sessions) {
    TellSession(session, out);
    if (CountIn(session.frames) == 0) continue;
    std::string& members = maps[session.map];
    members += (members.empty() ? "" : ", ") + std::to_string(session.id.value);
  }
  out << "maps      " << maps.size() << "\n";
  for (const auto& [id, members] : maps)
    out << "  " << id.value << ": sessions " << members << "\n";
  const std::vector<MergeReport> reports = mapper.MergeReports();
  out << "overlaps  " << reports.size() << "\n";
  for (const MergeReport& report : reports) {
    out << "  " << report.id << ": " << ToString(report.kind) << " of sessions "
        << report.other_session.value << " and " << report.query_session.value << ", "
        << ToString(report.verdict) << ": " << report.reason << "\n";
  }
}

void TellSizes(StoreDatabase* database, std::ostream& out) {
  for (const auto& [what, text] :
       {std::pair("images", "SELECT count(*), total(length(jpeg)) FROM image"),
        std::pair("descriptors", "SELECT count(*), total(length(data)) FROM descriptors"),
        std::pair("keypoints", "SELECT count(*), total(length(keypoints)) FROM frame"),
        std::pair("journal", "SELECT count(*), total(length(entries)) FROM journal")}) {
    Rows rows = database->Query(text);
    rows.Next();
    out << std::left << std::setw(12) << what
        << CountText(static_cast<uint64_t>(rows.Int(0)), "row") << ", " << std::fixed
        << std::setprecision(1) << rows.Double(1) / 1024.0 << " KiB\n";
  }
}

// The names of columns and the values of the rows that a check complains of.
std::vector<std::string> ComplaintsOf(const char* text, const char* name, StoreDatabase* database) {
  std::vector<std::string> complaints;
  Rows rows = database->Query(text);
  while (rows.Next()) {
    if (rows.Text(0) != "ok") complaints.push_back(std::string(name) + ": " + rows.Text(0));
  }
  return complaints;
}

// Every frame, whether or not a session holds it.
void CheckFrames(const StoredFrames& frames, std::vector<std::string>* faults) {
  for (const DriveRecord& drive : frames.ReadDrives()) {
    for (const uint32_t index : frames.ReadIndices(drive.id)) {
      const FrameId id{drive.id, index};
      try {
        frames.ReadEvent(id, EventParts::kAll);
      } catch (const StoreError& error) {
        faults->push_back("frame " + id.ToString() + ": " + error.what());
      }
    }
  }
}

void CheckMaps(MapStore* store, std::vector<std::string>* faults) {
  for (SessionRecord& record : store->sessions().Read(DefaultFrameMaker(), faults)) {
    const SessionId id = record.id;
    try {
      const std::string contradiction = CheckInvariants(Session(std::move(record)));
      if (contradiction.empty()) continue;
      faults->push_back("session " + std::to_string(id.value) + ": " + contradiction);
    } catch (const std::runtime_error& error) {
      faults->push_back(error.what());
    }
  }
  store->merges().Read();
}

std::string PlaceholdersOf(const PruneChoice& choice, const StoredFrames& frames) {
  std::string rows;
  std::map<std::string, int64_t> known;
  for (const DriveRecord& drive : frames.ReadDrives()) {
    known[drive.id.ToString()] = *frames.FindRow(drive.id);
  }
  for (const std::string& name : choice.drives) {
    const auto drive = known.find(name);
    if (drive == known.end()) {
      throw std::runtime_error("drive = " + name + ": expected one that the store holds");
    }
    rows += (rows.empty() ? "" : ", ") + std::to_string(drive->second);
  }
  return rows;
}

}  // namespace

void TellContents(const std::filesystem::path& file, std::ostream& out) {
  MapStore store(file, StoreAccess::kRead);
  out << std::filesystem::absolute(file).string() << ": map store, version " << kStoreVersion
      << ", " << std::filesystem::file_size(file) / 1024 << " KiB\n";
  TellDrives(store.frames(), out);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  mapper.Restore(&store);
  TellMaps(mapper, out);
  StoreDatabase database(file, StoreAccess::kRead);
  TellSizes(&database, out);
}

std::vector<std::string> FindStoreFaults(const std::filesystem::path& file) {
  StoreDatabase database(file, StoreAccess::kRead);
  OpenSchema(StoreAccess::kRead, &database);
  std::vector<std::string> faults;
  const auto note = [&](const auto& check) {
    try {
      check();
    } catch (const std::exception& error) {
      faults.push_back(error.what());
    }
  };
  for (const auto& [text, name] : {std::pair("PRAGMA integrity_check", "integrity"),
                                   std::pair("PRAGMA foreign_key_check", "stray row of")}) {
    note([&, text = text, name = name] {
      for (std::string& complaint : ComplaintsOf(text, name, &database)) {
        faults.push_back(std::move(complaint));
      }
    });
  }
  note([&] {
    MapStore store(file, StoreAccess::kRead);
    note([&] { CheckFrames(store.frames(), &faults); });
    note([&] { CheckMaps(&store, &faults); });
  });
  return faults;
}

StorePruneReport PruneStore(const std::filesystem::path& file, const PruneChoice& choice) {
  StoreDatabase database(file, StoreAccess::kWrite);
  const std::unique_ptr<FolderLock> lock = LockStoreFile(file);
  StorePruneReport report;
  report.bytes_before = std::filesystem::file_size(file);
  OpenSchema(StoreAccess::kWrite, &database);
  const std::string drives = PlaceholdersOf(choice, StoredFrames(&database));
  const std::string which =
      drives.empty() ? "" : " WHERE frame >> 32 IN (" + drives + ")";  // see StoredFrames::FrameRow
  const auto count = [&] {
    Rows rows =
        database.Query("SELECT (SELECT count(*) FROM image) + (SELECT count(*) FROM descriptors)");
    rows.Next();
    return static_cast<size_t>(rows.Int(0));
  };
  const size_t before = count();
  database.Execute("BEGIN IMMEDIATE");
  if (choice.images) database.Execute("DELETE FROM image" + which);
  if (choice.descriptors) database.Execute("DELETE FROM descriptors" + which);
  database.Execute("COMMIT; VACUUM; PRAGMA wal_checkpoint(TRUNCATE)");
  report.num_rows = before - count();
  report.bytes_after = std::filesystem::file_size(file);
  return report;
}

}  // namespace rovio_sfm
