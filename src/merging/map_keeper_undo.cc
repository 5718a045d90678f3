// Taking a session out of its map again (design 5.4).

#include <set>

#include "rovio_sfm/merging/group_pairs.h"
#include "rovio_sfm/merging/map_keeper.h"
#include "rovio_sfm/merging/undo_merge.h"

namespace rovio_sfm {

std::vector<MergeReport> MapKeeper::Unmerge(SessionId id) {
  const UndoPlan plan = PlanUndo(id, &list_);
  std::vector<MergeReport> reports;
  if (plan.undone.empty()) return reports;
  list_.Separate(id, sessions_);
  for (MergeEdit* edit : plan.undone) {
    edit->report.verdict = MergeVerdict::kUndone;
    edit->marks.clear();
    reports.push_back(edit->report);
  }
  for (MergeEdit* edit : plan.repeated) {
    edit->report.verdict = MergeVerdict::kWaiting;
    edit->marks.clear();
  }
  std::set<MapId> interrupted;
  std::set<SessionId> of_them;
  for (const auto& [session, mark] : plan.marks) {
    const MapId map = list_.PlaceOf(session).map;
    if (running_.erase(map) > 0) interrupted.insert(map);
    if (interrupted.count(map) != 0) of_them.insert(session);
    list_.RaiseRevision(list_.PlaceOf(session).map);
    RestoreSession(mark, options_, sessions_.Lend(session));
  }
  list_.Place();
  for (const auto& [session, mark] : plan.marks) list_.RaiseRevision(list_.PlaceOf(session).map);
  for (MergeEdit* edit : plan.repeated) Repeat(edit);
  for (const SessionId session : of_them) AdjustAgain(list_.PlaceOf(session).map);
  return reports;
}

// In the name of the newest edit, unless it is being adjusted.
void MapKeeper::AdjustAgain(MapId map) {
  if (running_.count(map) != 0) return;
  for (auto edit = list_.edits().rbegin(); edit != list_.edits().rend(); ++edit) {
    if (list_.IsAcceptedIn(map, *edit)) return StartAdjusting(map, *edit);
  }
}

// Makes an edit again, by what its overlap says of the sessions as they are; where it says nothing
// any more, as it was.
void MapKeeper::Repeat(MergeEdit* edit) {
  const MergeReport before = edit->report;
  OverlapTrial trial = Retry(*edit);
  if (trial.report.num_inliers > 0) {
    edit->report = std::move(trial.report);
    edit->report.id = before.id;
    edit->report.reason = before.reason;
    edit->links = trial.links;
  }
  edit->report.kind = before.kind == MergeKind::kLoop ? MergeKind::kMerge : before.kind;
  Accept(before.accepted_by, edit);
}

OverlapTrial MapKeeper::Retry(const MergeEdit& edit) {
  const Session* query = sessions_.FindHolder(edit.match.query);
  const SessionId other = edit.report.other_session;
  const PairsBySession pairs = GroupPairs(edit.match, sessions_);
  const auto of_other = pairs.find(other);
  if (query == nullptr || !(query->id() == edit.report.query_session) || of_other == pairs.end()) {
    return {};
  }
  if (auto link = TryLink(edit.match, other, query->id(), of_other->second)) return *link;
  return TryOverlap(*sessions_.Find(other), *query, edit.match.query, of_other->second, options_,
                    *store_);
}

}  // namespace rovio_sfm
