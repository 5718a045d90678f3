#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "rovio_sfm/io/map_store.h"
#include "rovio_sfm/mapping/drive_mapper.h"
#include "rovio_sfm/merging/map_keeper.h"
#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// From frame events to maps (§3.7–3.8): every drive is mapped by itself, in sessions that follow
// one another when tracking is lost. Thread-compatible: one owner calls it; the snapshots it hands
// out are immutable and may go anywhere.
class Mapper {
 public:
  // The store, the times (may be null) and the executor of global adjustments must outlive the
  // mapper. Options must be valid.
  Mapper(const MapOptions& options, FrameStore* store, Executor* executor,
         StageTimes* times = nullptr, ResultTiming timing = ResultTiming::kFixed);

  // Goes on with the maps that the store holds; before any event came. Throws StoreError.
  void Restore(MapStore* store);
  // Commits what changed to the store, by which it was made too. False: it says why.
  bool SaveTo(MapStore* store);

  const MapKeeper& maps() const { return keeper_; }

  // Takes the next event of its drive. An event that does not fit (index not increasing, camera of
  // the drive changed) is refused, with the reason; the maps stay as they were.
  MapperReport Add(const FrameEvent& event);

  // Takes an overlap: joins the maps it touches, closes a loop, or waits for its frames (§4.3).
  // MergeReports says what became of it.
  void Add(const PlaceMatch& match);
  // Maps a whole drive from the maps that its frames see (§4.3.2, Algorithm 2): seeded where the
  // matches of its frames say, forward from there, then in reverse; where no match carries, from
  // its own best pair. The drive is finished then.
  void AddSeeded(const std::vector<FrameEvent>& events, const std::vector<PlaceMatch>& matches);
  // Live: applies the adjustments that are ready, without waiting for the next frame. False: none.
  bool ApplyDueResults() { return keeper_.ApplyDueResults(); }
  // Puts a frame that was added, but that no session holds, where its drive's sessions see it; the
  // match may be empty. After FinishDrives; Finish adjusts these sessions. False: none poses it.
  bool Rejoin(const FrameEvent& event, const PlaceMatch& place);
  // By request; see MapKeeper. The report says what was done, or why not.
  MergeReport Merge(SessionId a, SessionId b, bool force);
  MergeReport MergeAt(SessionId a, SessionId b, const Sim3& b_from_a);
  std::vector<MergeReport> Unmerge(SessionId id);
  // All overlaps judged so far.
  std::vector<MergeReport> MergeReports() const { return keeper_.Reports(); }
  // Place matches that wait for their frames, poses or scale.
  size_t num_matches_waiting() const { return keeper_.num_waiting(); }
  // Place matches ignored because their frames had been judged together before.
  uint64_t num_matches_repeated() const { return keeper_.num_repeated(); }

  // Closes the drive's current session with its final adjustment; should the drive go on, its next
  // frame opens another. False if the drive is unknown.
  bool FinishSession(const DriveId& drive);
  // Closes every drive's current session.
  void FinishDrives();
  // The same, and adjusts all maps finally.
  void Finish();

  std::shared_ptr<const MapSnapshot> Snapshot() const;
  // The map of a snapshot that still holds (nothing was added or merged since), as exporters want
  // it. Throws std::runtime_error where the store lacks a frame.
  MapModel ModelOf(const LevelMap& map) const;
  MapperCounters counters() const;
  // The index after the newest event of each drive.
  std::map<DriveId, uint32_t> NextIndices() const;

 private:
  void TrySeed(const DriveId& drive);
  SessionId StartedSession(const DriveMapper& drive) const;
  void MatchWithLast(SessionId session);
  std::vector<Sibling> SiblingsOf(const Session& session) const;
  void FinishDrive(const DriveId& drive);
  void AdjustMaps(std::optional<SessionId> of);

  MapOptions options_;
  MapKeeper keeper_;
  MapperContext context_;
  std::map<DriveId, std::unique_ptr<DriveMapper>> drives_;
  std::set<SessionId> rejoined_;  // sessions that got frames again
  mutable uint64_t version_ = 0;
};

}  // namespace rovio_sfm
