#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/mapping/session_table.h"
#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/merging/merge_ledger.h"
#include "rovio_sfm/merging/try_overlap.h"
#include "rovio_sfm/scene/frame_store.h"

namespace rovio_sfm {

// Joins sessions into maps (§4.3): judges overlaps, and adjusts the maps that the accepted ones
// make. Any number of sessions and overlaps, in any order. Sessions are changed only by adjusting
// maps and by undoing. Thread-compatible.
class MapMerger {
 public:
  // Options must be valid; the store must outlive this.
  MapMerger(const MapOptions& options, const FrameStore* store);

  // Judges a place match at once or, where its frames or sessions are not there yet, later. One
  // whose frame and matched frame were judged together before, or wait, is counted and ignored.
  void Add(const PlaceMatch& match, const SessionTable& sessions);
  // Counts a keyframe and tries again what waits.
  void Advance(const SessionTable& sessions);

  // Joins the maps of two sessions by the best overlap known of them; `force` takes one that was
  // refused for lack of evidence. The verdict is kRefused where none is known.
  MergeReport Merge(SessionId a, SessionId b, bool force, const SessionTable& sessions);
  // Joins them as the caller says, without evidence and without links.
  MergeReport MergeAt(SessionId a, SessionId b, const Sim3& b_from_a, const SessionTable& sessions);
  // The session leaves its map, and no place match brings it back: every merge that it took part in
  // is undone, and frames that were there before are what they were. Merges of other sessions made
  // since are made again. Returns what was undone; empty: it was alone.
  std::vector<MergeReport> Unmerge(SessionId id, const SessionTable& sessions);

  // The final adjustment of every map that links join.
  void AdjustFinally(const SessionTable& sessions);
  // No more frames come: what waits gives up, with the reason.
  void GiveUpWaiting();

  MapPlace PlaceOf(SessionId id) const { return ledger_.PlaceOf(id); }
  // The landmarks of each map that are one point, as it was last adjusted.
  const std::map<MapId, std::shared_ptr<const SharedLandmarks>>& shared_landmarks() const {
    return shared_;
  }
  // All overlaps judged so far, by id, and those that waited in vain.
  std::vector<MergeReport> Reports() const;
  size_t num_waiting() const { return waiting_.size(); }
  uint64_t num_repeated() const { return num_repeated_; }  // place matches ignored
  // Matches that wait whose query is a frame of the drive.
  std::vector<PlaceMatch> WaitingFor(const DriveId& drive) const;
  // The sessions that were changed here since the last call.
  std::set<SessionId> TakeChanged() { return std::exchange(changed_, {}); }

 private:
  struct Waiting {
    PlaceMatch match;
    int age = 0;  // keyframes
    std::string reason;
    bool needs_scale = false;  // not tried again before both sessions know theirs, or have ended
  };

  bool IsRepeated(const PlaceMatch& match) const;
  void Take(const PlaceMatch& match, const SessionTable& sessions);
  bool TryNow(Waiting* entry, const SessionTable& sessions);
  bool LinkLoop(const PlaceMatch& match, SessionId a, SessionId b,
                const std::vector<OverlapPair>& pairs, const SessionTable& sessions);
  void Judge(const PlaceMatch& match, OverlapTrial trial, const SessionTable& sessions);
  void Accept(MergeRecord* record, const SessionTable& sessions);
  void KeepBefore(const SessionTable& sessions, MergeRecord* record) const;
  void CloseLoop(MergeRecord* record, const SessionTable& sessions);
  void Adjust(MapId map, bool is_final, const SessionTable& sessions, MergeReport* report);
  void GiveUp(const Waiting& waiting);
  bool IsSeparated(SessionId a, SessionId b) const;

  void Separate(SessionId id);
  void Undo(const std::vector<MergeRecord*>& records, const SessionTable& sessions);
  void Repeat(const MergeRecord& record, const SessionTable& sessions);

  MapOptions options_;
  const FrameStore* store_;
  std::deque<Waiting> waiting_;
  uint64_t num_repeated_ = 0;
  MergeLedger ledger_;
  std::map<MapId, std::shared_ptr<const SharedLandmarks>> shared_;
  std::set<std::pair<SessionId, SessionId>> separated_;  // by request, smaller id first
  std::set<SessionId> changed_;
};

}  // namespace rovio_sfm
