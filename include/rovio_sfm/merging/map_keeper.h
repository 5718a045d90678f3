#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "rovio_sfm/io/map_store.h"
#include "rovio_sfm/merging/adjust_map.h"
#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/merging/merge_list.h"
#include "rovio_sfm/merging/try_overlap.h"
#include "rovio_sfm/merging/waiting_matches.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/session_table.h"

namespace rovio_sfm {

// The keeper of all sessions and of the list of edits that makes maps of them (§4.3): judges
// overlaps, and adjusts the maps that the accepted ones make. Any number of sessions and overlaps,
// in any order. Thread-compatible.
class MapKeeper {
 public:
  // Options must be valid; store, executor (of the maps' adjustments) and times (may be null) must
  // outlive this.
  MapKeeper(const MapOptions& options, const FrameStore* store, Executor* executor,
            ResultTiming timing, StageTimes* times = nullptr);

  const SessionTable& sessions() const { return sessions_; }
  // To the mappers of drives, each for the step that is run: a drive opens and changes its own
  // sessions only, and sees by their revision what was changed here.
  SessionTable* LendSessions() { return &sessions_; }

  // Judges a place match at once or, where its frames or sessions are not there yet, later. One
  // whose frame and matched frame were judged together before, or wait, is counted and ignored.
  void Add(const PlaceMatch& match);
  // Counts a keyframe and tries again what waits.
  void Advance();

  // Joins the maps of two sessions by the best overlap known of them; `force` takes one that was
  // refused for lack of evidence. The verdict is kRefused where none is known.
  MergeReport Merge(SessionId a, SessionId b, bool force);
  // Joins them as the caller says, without evidence and without links.
  MergeReport MergeAt(SessionId a, SessionId b, const Sim3& b_from_a);
  // The session leaves its map, and no place match brings it back: every edit that it shares with
  // another session is taken out of the list, and frames that were there before the first of them
  // are what they were. Edits of others made since are made again, as they were accepted. Returns
  // what was undone; empty: it was alone.
  std::vector<MergeReport> Unmerge(SessionId id);

  // Counts a keyframe, applies the results of adjustments that are due, and begins those of linked
  // maps that have grown.
  void CountKeyframe();
  bool ApplyDueResults();  // false: none was
  // Whether links join the map of a session, of several sessions or of laps of one.
  bool IsLinked(SessionId id) const { return list_.HasLinks(list_.PlaceOf(id).map); }
  // The final adjustment of the map of a session, if links join it; of all maps, and then of those
  // that matches which waited for it have changed. Waits for it.
  void AdjustFinally(SessionId of) { AdjustMapOf(list_.PlaceOf(of).map); }
  void AdjustAllFinally();
  // No more frames come: what waits gives up, with the reason.
  void GiveUpWaiting() {
    waiting_.Clear([this](const WaitingMatch& waiting) { KeepWaitedInVain(waiting); });
  }

  // Puts what changed into the store's next commit. Throws StoreError.
  void PutInto(MapStore* store);
  // Takes over what a store held, in place of nothing; adjustments that were running begin again.
  // Throws StoreError where a session contradicts itself.
  void Restore(std::vector<SessionRecord> sessions, MergeRecord merges);

  MapPlace PlaceOf(SessionId id) const { return list_.PlaceOf(id); }
  // The landmarks of each map that are one point, as it was last adjusted.
  const std::map<MapId, std::shared_ptr<const SharedLandmarks>>& shared_landmarks() const {
    return shared_;
  }
  // All overlaps judged so far, by id, and those that waited in vain.
  std::vector<MergeReport> Reports() const;
  size_t num_waiting() const { return waiting_.size(); }
  uint64_t num_repeated() const { return num_repeated_; }  // place matches ignored
  // Matches that wait whose query is a frame of the drive.
  std::vector<PlaceMatch> WaitingFor(const DriveId& drive) const { return waiting_.OfDrive(drive); }

 private:
  bool TryNow(WaitingMatch* entry);
  OverlapTrial Retry(const MergeEdit& edit);
  std::optional<OverlapTrial> TryLink(const PlaceMatch& match, SessionId a, SessionId b,
                                      const std::vector<OverlapPair>& pairs);
  void Judge(const PlaceMatch& match, OverlapTrial trial);
  void Accept(AcceptedBy by, MergeEdit* edit);
  void MarkSessions(MergeEdit* edit);
  void CloseLoop(MergeEdit* edit);
  void StartAdjusting(MapId map, const MergeEdit& edit);
  void AdjustAgain(MapId map);
  void AdjustGrownMaps();
  void ApplyAdjustment(MapId map);
  void TakeOver(MapId map, MapAdjustmentReport report, const std::vector<FeatureLink>& links);
  void AdjustMapOf(MapId map);
  void KeepWaitedInVain(const WaitingMatch& waiting);

  void Repeat(MergeEdit* edit);

  struct Running {
    MapAdjustment adjustment;
    uint32_t edit = 0;  // whose report hears of it
  };

  MapOptions options_;
  const FrameStore* store_;
  Executor* executor_;
  ResultTiming timing_;
  StageTimes* times_;
  SessionTable sessions_;
  WaitingMatches waiting_;
  uint64_t num_repeated_ = 0;
  MergeList list_;
  std::map<MapId, std::shared_ptr<const SharedLandmarks>> shared_;
  std::map<MapId, Running> running_;            // one a map
  std::map<MapId, size_t> num_frames_at_last_;  // when its last adjustment began
};

}  // namespace rovio_sfm
