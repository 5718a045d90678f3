#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/mapping/session_table.h"
#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/scene/place_match.h"

namespace rovio_sfm {

// An overlap that was judged. One that joined two maps keeps what they were just before.
struct MergeRecord {
  MergeReport report;
  PlaceMatch match;
  std::vector<FeatureLink> links;  // sorted
  std::map<SessionId, std::shared_ptr<const Session>> before;

  bool IsAccepted() const { return report.verdict == MergeVerdict::kAccepted; }
  bool IsMerge() const { return IsAccepted() && report.kind != MergeKind::kLoop; }
};

// A session's place, as the world may know it.
struct MapPlace {
  MapId map;
  Sim3 map_from_session;
  uint32_t revision = 0;  // of the map's gauge
};

// Every overlap that was judged, and the maps that the accepted ones make. Keeps the two in step
// and does no work of its own.
class MergeLedger {
 public:
  // Takes a record, with the next id.
  MergeRecord& Keep(MergeRecord record);
  std::deque<MergeRecord>& records() { return records_; }  // references stay; call Place after
  const std::deque<MergeRecord>& records() const { return records_; }

  // Places every session anew by the accepted merges.
  void Place();
  MapPlace PlaceOf(SessionId id) const;
  bool InOneMap(const MergeReport& report) const;
  // Of a map whose gauge, or what is in it, was changed.
  void RaiseRevision(MapId map) { ++revisions_[map]; }

  // The sessions of a map that have frames, the root first, so that it holds the gauge.
  std::vector<PlacedSession> SessionsOf(MapId map, const SessionTable& sessions) const;
  // The accepted links of a map, sorted; those of one record may be left out.
  std::vector<FeatureLink> LinksOf(MapId map, const MergeRecord* except = nullptr) const;
  // Forgets the links of a map that are not among those kept (sorted).
  void KeepLinks(MapId map, const std::vector<FeatureLink>& kept);
  // True where a place match that was judged holds these two frames, whichever was its query.
  bool HasJudged(const FrameId& a, const FrameId& b) const;
  // How many accepted overlaps join two drives.
  int CountAccepted(const DriveId& a, const DriveId& b) const;

 private:
  std::deque<MergeRecord> records_;               // by report.id
  std::set<std::pair<FrameId, FrameId>> judged_;  // smaller id first
  std::map<SessionId, MapPlace> places_;          // of sessions in merged maps
  std::map<MapId, uint32_t> revisions_;
};

}  // namespace rovio_sfm
