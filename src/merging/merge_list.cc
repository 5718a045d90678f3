#include "rovio_sfm/merging/merge_list.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/sessions/session_connectivity.h"

namespace rovio_sfm {

void MergeList::RememberJudged(const PlaceMatch& match) {
  for (const OverlapPair& pair : match.pairs) {
    judged_.insert(std::minmax(match.query, pair.other));
  }
}

void MergeList::Restore(MergeRecord record) {
  edits_.clear();
  for (MergeEdit& edit : record.edits) {
    RememberJudged(edit.match);
    edits_.push_back(std::move(edit));
  }
  num_accepted_ = record.num_accepted;
  revisions_ = std::move(record.revisions);
  separated_ = std::move(record.separated);
  Place();
}

MergeEdit& MergeList::Keep(MergeEdit edit) {
  edit.report.id = edits_.empty() ? 1 : edits_.back().report.id + 1;
  RememberJudged(edit.match);
  edits_.push_back(std::move(edit));
  return edits_.back();
}

MergeEdit& MergeList::Keep(const PlaceMatch& match, OverlapTrial trial) {
  MergeEdit edit;
  edit.report = std::move(trial.report);
  edit.match = match;
  edit.links = trial.links;
  return Keep(std::move(edit));
}

void MergeList::Place() {
  std::vector<SessionLink> merges;
  for (const MergeEdit& edit : edits_) {
    const MergeReport& report = edit.report;
    if (!edit.IsMerge()) continue;
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

void MergeList::Accept(AcceptedBy by, MergeEdit* edit) {
  edit->report.verdict = MergeVerdict::kAccepted;
  edit->report.accepted_by = by;
  edit->sequence = ++num_accepted_;
}

MapPlace MergeList::PlaceOf(SessionId id) const {
  const auto it = places_.find(id);
  MapPlace place = it == places_.end() ? MapPlace{{id.value}, {}, 0} : it->second;
  const auto revision = revisions_.find(place.map);
  if (revision != revisions_.end()) place.revision = revision->second;
  return place;
}

bool MergeList::AreInOneMap(SessionId a, SessionId b) const {
  return PlaceOf(a).map == PlaceOf(b).map;
}

std::vector<SessionId> MergeList::MembersOf(MapId map, const SessionTable& sessions) const {
  std::vector<SessionId> members;
  for (const auto& [id, session] : sessions.all()) {
    if (PlaceOf(id).map == map) members.push_back(id);
  }
  return members;
}

std::vector<PlacedSession> MergeList::SessionsOf(MapId map, SessionTable* sessions) const {
  std::vector<PlacedSession> placed;
  for (const auto& [id, session] : sessions->all()) {
    const MapPlace place = PlaceOf(id);
    if (!(place.map == map) || session->keyframes().empty()) continue;
    placed.push_back({session.get(), place.map_from_session});
  }
  return placed;
}

std::vector<FeatureLink> MergeList::LinksOf(MapId map, const MergeEdit* except) const {
  std::vector<FeatureLink> links;
  for (const MergeEdit& edit : edits_) {
    if (&edit == except || !IsAcceptedIn(map, edit)) continue;
    const std::vector<FeatureLink> of_edit = edit.links.List();
    links.insert(links.end(), of_edit.begin(), of_edit.end());
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

bool MergeList::HasLinks(MapId map) const {
  return std::any_of(edits_.begin(), edits_.end(), [&](const MergeEdit& edit) {
    return edit.links.size() > 0 && IsAcceptedIn(map, edit);
  });
}

std::set<MapId> MergeList::LinkedMaps() const {
  std::set<MapId> maps;
  for (const MergeEdit& edit : edits_) {
    if (edit.IsAccepted() && edit.links.size() > 0) {
      maps.insert(PlaceOf(edit.report.query_session).map);
    }
  }
  return maps;
}

bool MergeList::IsAcceptedIn(MapId map, const MergeEdit& edit) const {
  return edit.IsAccepted() && PlaceOf(edit.report.query_session).map == map;
}

void MergeList::KeepLinks(MapId map, const std::vector<FeatureLink>& kept) {
  for (MergeEdit& edit : edits_) {
    if (!IsAcceptedIn(map, edit)) continue;
    const auto is_gone = [&](const FeatureLink& link) {
      return !std::binary_search(kept.begin(), kept.end(), link);
    };
    std::vector<FeatureLink> links = edit.links.List();
    links.erase(std::remove_if(links.begin(), links.end(), is_gone), links.end());
    edit.links = links;
  }
}

bool MergeList::HasJudged(const FrameId& a, const FrameId& b) const {
  return judged_.count(std::minmax(a, b)) != 0;
}

void MergeList::Separate(SessionId id, const SessionTable& sessions) {
  for (const SessionId other : MembersOf(PlaceOf(id).map, sessions)) {
    if (!(other == id)) separated_.insert(std::minmax(id, other));
  }
}

void MergeList::AllowJoining(SessionId a, SessionId b, const SessionTable& sessions) {
  for (const SessionId x : MembersOf(PlaceOf(a).map, sessions)) {
    for (const SessionId y : MembersOf(PlaceOf(b).map, sessions)) {
      separated_.erase(std::minmax(x, y));
    }
  }
}

bool MergeList::IsSeparated(SessionId a, SessionId b) const {
  const MapId map_a = PlaceOf(a).map, map_b = PlaceOf(b).map;
  if (map_a == map_b) return false;
  return std::any_of(separated_.begin(), separated_.end(), [&](const auto& pair) {
    const MapId x = PlaceOf(pair.first).map, y = PlaceOf(pair.second).map;
    return (x == map_a && y == map_b) || (x == map_b && y == map_a);
  });
}

int MergeList::CountAccepted(const DriveId& a, const DriveId& b) const {
  int count = 0;
  for (const MergeEdit& edit : edits_) {
    if (!edit.IsAccepted()) continue;
    const DriveId &x = edit.report.query.drive, &y = edit.report.other.drive;
    count += (x == a && y == b) || (x == b && y == a) ? 1 : 0;
  }
  return count;
}

}  // namespace rovio_sfm
