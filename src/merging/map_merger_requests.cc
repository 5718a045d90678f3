// The part of MapMerger that answers requests: merging and undoing by hand.
#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "rovio_sfm/merging/map_merger.h"
#include "rovio_sfm/merging/undo_merge.h"

namespace rovio_sfm {
namespace {

MergeReport Refuse(SessionId a, SessionId b, const std::string& reason) {
  MergeReport report;
  report.verdict = MergeVerdict::kRefused;
  report.other_session = a;
  report.query_session = b;
  report.reason = reason;
  return report;
}

bool Joins(const MergeReport& report, SessionId a, SessionId b) {
  const SessionId x = report.other_session, y = report.query_session;
  return (x == a && y == b) || (x == b && y == a);
}

bool TakesPart(const MergeRecord& record, SessionId id) {
  const MergeReport& report = record.report;
  return record.IsMerge() && (report.query_session == id || report.other_session == id);
}

}  // namespace

MergeReport MapMerger::Merge(SessionId a, SessionId b, bool force, const SessionTable& sessions) {
  if (ledger_.PlaceOf(a).map == ledger_.PlaceOf(b).map) {
    return Refuse(a, b, "they are in one map already");
  }
  MergeRecord* best = nullptr;
  for (MergeRecord& record : ledger_.records()) {
    const MergeVerdict verdict = record.report.verdict;
    const bool possible = verdict == MergeVerdict::kProvisional ||
                          verdict == MergeVerdict::kUndone ||
                          (force && verdict == MergeVerdict::kRefused);
    if (!possible || !Joins(record.report, a, b) || record.report.num_inliers == 0) continue;
    if (best == nullptr || record.report.num_inliers > best->report.num_inliers) best = &record;
  }
  if (best == nullptr) return Refuse(a, b, "no overlap of these sessions is known");
  separated_.erase({std::min(a, b), std::max(a, b)});
  best->report.kind = MergeKind::kMerge;
  best->report.reason = "accepted by request";
  Accept(best, sessions);
  return best->report;
}

MergeReport MapMerger::MergeAt(SessionId a, SessionId b, const Sim3& b_from_a,
                               const SessionTable& sessions) {
  if (ledger_.PlaceOf(a).map == ledger_.PlaceOf(b).map) {
    return Refuse(a, b, "they are in one map already");
  }
  MergeRecord record;
  record.report.other_session = a;
  record.report.query_session = b;
  record.report.query_from_other = b_from_a;
  record.report.reason = "placed by request";
  MergeRecord& kept = ledger_.Keep(std::move(record));
  separated_.erase({std::min(a, b), std::max(a, b)});
  Accept(&kept, sessions);
  return kept.report;
}

std::vector<MergeReport> MapMerger::Unmerge(SessionId id, const SessionTable& sessions) {
  std::vector<MergeRecord*> since;  // accepted overlaps of the map, from its first merge on
  std::vector<MergeRecord> again;
  std::vector<MergeReport> undone;
  const MapId map = ledger_.PlaceOf(id).map;
  for (MergeRecord& record : ledger_.records()) {
    const bool meant = TakesPart(record, id);
    if (since.empty() && !meant) continue;
    if (!record.IsAccepted() || !(ledger_.PlaceOf(record.report.query_session).map == map))
      continue;
    since.push_back(&record);
    if (!meant) again.push_back(record);
    if (!meant) continue;
    undone.push_back(record.report);
    undone.back().verdict = MergeVerdict::kUndone;
  }
  if (undone.empty()) return {};
  Separate(id);
  Undo(since, sessions);
  for (const MergeRecord& record : again) Repeat(record, sessions);
  return undone;
}

// Place matches between the session and the others of its map count no more.
void MapMerger::Separate(SessionId id) {
  for (const MergeRecord& record : ledger_.records()) {
    if (!TakesPart(record, id)) continue;
    const SessionId x = record.report.other_session, y = record.report.query_session;
    separated_.insert({std::min(x, y), std::max(x, y)});
  }
}

// Gives all sessions that the records touched back what they were before the first of them.
void MapMerger::Undo(const std::vector<MergeRecord*>& records, const SessionTable& sessions) {
  std::map<SessionId, std::shared_ptr<const Session>> before;
  for (MergeRecord* record : records) {
    for (const auto& [id, session] : record->before) before.try_emplace(id, session);
    record->report.verdict = MergeVerdict::kUndone;
    record->before.clear();
  }
  for (const auto& [id, session] : before) {
    ledger_.RaiseRevision(ledger_.PlaceOf(id).map);
    RestoreSession(*session, options_, sessions.Find(id));
    changed_.insert(id);
  }
  ledger_.Place();
  for (const auto& [id, session] : before) ledger_.RaiseRevision(ledger_.PlaceOf(id).map);
}

// Makes again a merge that was undone with another one.
void MapMerger::Repeat(const MergeRecord& record, const SessionTable& sessions) {
  if (record.match.pairs.empty()) {
    MergeAt(record.report.other_session, record.report.query_session,
            record.report.query_from_other, sessions);
  } else {
    Take(record.match, sessions);
  }
}

}  // namespace rovio_sfm
