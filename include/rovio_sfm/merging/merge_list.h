#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/merging/try_overlap.h"
#include "rovio_sfm/scene/map_record.h"
#include "rovio_sfm/scene/merge_edit.h"
#include "rovio_sfm/scene/session_table.h"

namespace rovio_sfm {

// A session's place, as the world may know it.
struct MapPlace {
  MapId map;
  Sim3 map_from_session;
  uint32_t revision = 0;  // of the map's gauge
};

// Every overlap that was judged, as a list of edits, and the maps that the accepted ones make.
// Keeps the two in step and does no work of its own.
class MergeList {
 public:
  // Takes an edit, with the next id.
  MergeEdit& Keep(MergeEdit edit);
  MergeEdit& Keep(const PlaceMatch& match, OverlapTrial trial);
  std::deque<MergeEdit>& edits() { return edits_; }  // references stay; call Place after
  const std::deque<MergeEdit>& edits() const { return edits_; }
  // As it was kept; places every session.
  void Restore(MergeRecord record);
  uint32_t num_accepted() const { return num_accepted_; }
  const std::map<MapId, uint32_t>& revisions() const { return revisions_; }
  const std::set<std::pair<SessionId, SessionId>>& separated() const { return separated_; }
  // Accepts an edit, after all others accepted so far.
  void Accept(AcceptedBy by, MergeEdit* edit);

  // Places every session anew by the accepted merges.
  void Place();
  MapPlace PlaceOf(SessionId id) const;
  bool AreInOneMap(SessionId a, SessionId b) const;
  // Of a map whose gauge, or what is in it, was changed.
  void RaiseRevision(MapId map) { ++revisions_[map]; }

  // All sessions of a map.
  std::vector<SessionId> MembersOf(MapId map, const SessionTable& sessions) const;
  // The sessions of a map that have frames, the root first, so that it holds the gauge.
  std::vector<PlacedSession> SessionsOf(MapId map, SessionTable* sessions) const;
  // The accepted links of a map, sorted; those of one edit may be left out.
  std::vector<FeatureLink> LinksOf(MapId map, const MergeEdit* except = nullptr) const;
  bool HasLinks(MapId map) const;
  std::set<MapId> LinkedMaps() const;
  bool IsAcceptedIn(MapId map, const MergeEdit& edit) const;
  // Forgets the links of a map that are not among those kept (sorted).
  void KeepLinks(MapId map, const std::vector<FeatureLink>& kept);
  // True where a place match that was judged holds these two frames, whichever was its query.
  bool HasJudged(const FrameId& a, const FrameId& b) const;
  // By request: no place match joins the session with the others of its map again …
  void Separate(SessionId id, const SessionTable& sessions);
  // … until a later request joins these two maps.
  void AllowJoining(SessionId a, SessionId b, const SessionTable& sessions);
  bool IsSeparated(SessionId a, SessionId b) const;
  // How many accepted overlaps join two drives.
  int CountAccepted(const DriveId& a, const DriveId& b) const;

 private:
  void RememberJudged(const PlaceMatch& match);

  std::deque<MergeEdit> edits_;                   // by report.id
  uint32_t num_accepted_ = 0;                     // so far, undone ones too
  std::set<std::pair<FrameId, FrameId>> judged_;  // smaller id first
  std::map<SessionId, MapPlace> places_;          // of sessions in merged maps
  std::map<MapId, uint32_t> revisions_;
  std::set<std::pair<SessionId, SessionId>> separated_;  // smaller id first
};

}  // namespace rovio_sfm
