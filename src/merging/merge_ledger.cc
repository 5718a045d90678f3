#include "rovio_sfm/merging/merge_ledger.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/sessions/session_connectivity.h"

namespace rovio_sfm {

MergeRecord& MergeLedger::Keep(MergeRecord record) {
  record.report.id = records_.empty() ? 1 : records_.back().report.id + 1;
  for (const OverlapPair& pair : record.match.pairs) {
    judged_.insert(std::minmax(record.match.query, pair.other));
  }
  records_.push_back(std::move(record));
  return records_.back();
}

void MergeLedger::Place() {
  std::vector<SessionLink> merges;
  for (const MergeRecord& record : records_) {
    const MergeReport& report = record.report;
    if (!record.IsMerge()) continue;
    merges.push_back({report.other_session, report.query_session, report.query_from_other,
                      static_cast<double>(report.num_inliers)});
  }
  places_.clear();
  for (const ConnectedMap& map : ConnectSessions({}, merges)) {
    for (const MapMember& member : map.members) {
      places_[member.session] = {map.id, member.map_from_session, 0};
    }
  }
}

MapPlace MergeLedger::PlaceOf(SessionId id) const {
  const auto it = places_.find(id);
  MapPlace place = it == places_.end() ? MapPlace{{id.value}, {}, 0} : it->second;
  const auto revision = revisions_.find(place.map);
  if (revision != revisions_.end()) place.revision = revision->second;
  return place;
}

bool MergeLedger::InOneMap(const MergeReport& report) const {
  return PlaceOf(report.other_session).map == PlaceOf(report.query_session).map;
}

std::vector<PlacedSession> MergeLedger::SessionsOf(MapId map, const SessionTable& sessions) const {
  std::vector<PlacedSession> placed;
  for (const auto& [id, session] : sessions.all()) {
    const MapPlace place = PlaceOf(id);
    if (!(place.map == map) || session->keyframes().empty()) continue;
    placed.push_back({session, place.map_from_session});
  }
  return placed;
}

std::vector<FeatureLink> MergeLedger::LinksOf(MapId map, const MergeRecord* except) const {
  std::set<FeatureLink> links;
  for (const MergeRecord& record : records_) {
    if (!record.IsAccepted() || &record == except) continue;
    if (!(PlaceOf(record.report.query_session).map == map)) continue;
    links.insert(record.links.begin(), record.links.end());
  }
  return {links.begin(), links.end()};
}

void MergeLedger::KeepLinks(MapId map, const std::vector<FeatureLink>& kept) {
  for (MergeRecord& record : records_) {
    if (!record.IsAccepted() || !(PlaceOf(record.report.query_session).map == map)) continue;
    const auto is_gone = [&](const FeatureLink& link) {
      return !std::binary_search(kept.begin(), kept.end(), link);
    };
    record.links.erase(std::remove_if(record.links.begin(), record.links.end(), is_gone),
                       record.links.end());
  }
}

bool MergeLedger::HasJudged(const FrameId& a, const FrameId& b) const {
  return judged_.count(std::minmax(a, b)) != 0;
}

int MergeLedger::CountAccepted(const DriveId& a, const DriveId& b) const {
  int count = 0;
  for (const MergeRecord& record : records_) {
    if (!record.IsAccepted()) continue;
    const DriveId &x = record.report.query.drive, &y = record.report.other.drive;
    count += (x == a && y == b) || (x == b && y == a) ? 1 : 0;
  }
  return count;
}

}  // namespace rovio_sfm
