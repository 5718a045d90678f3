#include "rovio_sfm/merging/map_merger.h"

#include <algorithm>
#include <map>

#include "rovio_sfm/merging/adjust_map.h"
#include "rovio_sfm/merging/confirm_overlap.h"
#include "rovio_sfm/merging/share_scales.h"
#include "rovio_sfm/merging/spread_gap.h"
#include "rovio_sfm/merging/try_loop.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxWaiting = 2000;           // place matches; the oldest gives up for one more
constexpr double kMaxScaleDisagreement = 3.0;  // sigmas, from where a report warns

bool IsRipe(const Session& session, const MergeOptions& options) {
  if (session.state() == SessionState::kFinished || session.state() == SessionState::kLost) {
    return true;
  }
  return session.keyframes().size() >= static_cast<size_t>(options.min_keyframes);
}

bool MayGetScale(const Session& session) {
  return session.state() == SessionState::kMapping && !session.scale();
}

using PairsBySession = std::map<SessionId, std::vector<OverlapPair>>;

// The pairs of the match by the session that holds their frames.
PairsBySession GroupPairs(const PlaceMatch& match, const SessionTable& sessions) {
  PairsBySession pairs;
  for (const OverlapPair& pair : match.pairs) {
    const Session* session = sessions.FindHolder(pair.other);
    if (session != nullptr) pairs[session->id()].push_back(pair);
  }
  return pairs;
}

// The session that shares most with the query; ties go to the smaller id.
SessionId FindRichest(const PairsBySession& pairs) {
  SessionId richest;
  size_t most = 0;
  for (const auto& [id, list] : pairs) {
    size_t count = 1;
    for (const OverlapPair& pair : list) count += pair.inliers.size();
    if (count <= most) continue;
    richest = id;
    most = count;
  }
  return richest;
}

bool HoldsBoth(const PlaceMatch& match, const FrameId& a, const FrameId& b) {
  return std::any_of(match.pairs.begin(), match.pairs.end(), [&](const OverlapPair& pair) {
    return std::minmax(match.query, pair.other) == std::minmax(a, b);
  });
}

}  // namespace

MapMerger::MapMerger(const MapOptions& options, const FrameStore* store)
    : options_(options), store_(store) {}

void MapMerger::Add(const PlaceMatch& match, const SessionTable& sessions) {
  if (IsRepeated(match)) {
    ++num_repeated_;
  } else {
    Take(match, sessions);
  }
}

// As place recognition tells again after a restart.
bool MapMerger::IsRepeated(const PlaceMatch& match) const {
  const FrameId& other = match.pairs.front().other;
  const auto repeats = [&](const Waiting& entry) {
    return HoldsBoth(entry.match, match.query, other);
  };
  return ledger_.HasJudged(match.query, other) ||
         std::any_of(waiting_.begin(), waiting_.end(), repeats);
}

void MapMerger::Take(const PlaceMatch& match, const SessionTable& sessions) {
  Waiting entry{match, 0, "", false};
  if (TryNow(&entry, sessions)) return;
  waiting_.push_back(std::move(entry));
  if (waiting_.size() <= kMaxWaiting) return;
  GiveUp(waiting_.front());
  waiting_.pop_front();
}

void MapMerger::Advance(const SessionTable& sessions) {
  std::deque<Waiting> waiting = std::exchange(waiting_, {});
  for (Waiting& entry : waiting) {
    if (TryNow(&entry, sessions)) continue;
    if (++entry.age > options_.merge.patience) {
      GiveUp(entry);
    } else {
      waiting_.push_back(std::move(entry));
    }
  }
}

// False, and why, where the match must wait.
bool MapMerger::TryNow(Waiting* entry, const SessionTable& sessions) {
  const PlaceMatch& match = entry->match;
  const Session* query = sessions.FindHolder(match.query);
  const PairsBySession pairs = GroupPairs(match, sessions);
  if (query == nullptr || pairs.empty()) {
    const FrameId& missing = query == nullptr ? match.query : match.pairs.front().other;
    entry->reason = "frame " + missing.ToString() + " has no pose";
    return false;
  }
  const Session& other = *sessions.Find(FindRichest(pairs));
  if (!IsRipe(*query, options_.merge) || !IsRipe(other, options_.merge)) {
    entry->reason = "a session has too few keyframes";
    return false;
  }
  const int max_overlaps = options_.merge.max_overlaps;
  const bool used_up =
      max_overlaps > 0 && ledger_.CountAccepted(match.query.drive, other.drive()) >= max_overlaps;
  if (used_up || IsSeparated(query->id(), other.id())) return true;
  const std::vector<OverlapPair>& of_other = pairs.at(other.id());
  if (LinkLoop(match, other.id(), query->id(), of_other, sessions)) return true;
  const bool scale_may_come = MayGetScale(*query) || MayGetScale(other);
  if (entry->needs_scale && scale_may_come) return false;
  OverlapTrial trial = TryOverlap(other, *query, match.query, of_other, options_, *store_);
  entry->needs_scale = trial.needs_scale && scale_may_come;
  entry->reason = trial.report.reason;
  if (entry->needs_scale) return false;
  Judge(match, std::move(trial), sessions);
  return true;
}

// An overlap within one map that fits it as it is only adds its links.
bool MapMerger::LinkLoop(const PlaceMatch& match, SessionId a, SessionId b,
                         const std::vector<OverlapPair>& pairs, const SessionTable& sessions) {
  const MapPlace place_a = ledger_.PlaceOf(a), place_b = ledger_.PlaceOf(b);
  if (!(place_a.map == place_b.map)) return false;
  auto trial = TryLoop({sessions.Find(a), place_a.map_from_session},
                       {sessions.Find(b), place_b.map_from_session}, match.query, pairs, options_);
  if (!trial) return false;
  ledger_.Keep({std::move(trial->report), match, std::move(trial->links), {}});
  return true;
}

void MapMerger::Judge(const PlaceMatch& match, OverlapTrial trial, const SessionTable& sessions) {
  MergeRecord& record = ledger_.Keep({std::move(trial.report), match, std::move(trial.links), {}});
  MergeReport& report = record.report;
  if (report.verdict == MergeVerdict::kRefused) return;
  if (ledger_.InOneMap(report)) {
    // What the map says already needs no more proof; what contradicts it needs all.
    report.kind = MergeKind::kLoop;
    const LoopStatement loop = MeasureLoop(report, ledger_, sessions);
    if (IsSmall(loop.gap, options_.merge) &&
        loop.gap.distance <= options_.merge.max_drift * loop.way) {
      report.verdict = MergeVerdict::kAccepted;
      report.reason = "agrees with the map";
    }
  } else if (!options_.merge.automatic) {
    report.verdict = MergeVerdict::kProvisional;
    report.reason = "automatic merging is off";
    return;
  }
  if (report.verdict == MergeVerdict::kAccepted) return Accept(&record, sessions);
  MergeRecord* other = FindConfirmation(record, options_.merge, sessions, &ledger_);
  if (other == nullptr) return;
  report.reason = "confirmed by overlap " + std::to_string(other->report.id);
  other->report.reason = "confirmed by overlap " + std::to_string(report.id);
  Accept(other, sessions);
  Accept(&record, sessions);
}

void MapMerger::Accept(MergeRecord* record, const SessionTable& sessions) {
  MergeReport& report = record->report;
  report.verdict = MergeVerdict::kAccepted;
  if (ledger_.InOneMap(report)) {
    report.kind = MergeKind::kLoop;
    return CloseLoop(record, sessions);
  }
  KeepBefore(sessions, record);
  const double disagreement =
      ScaleDisagreement(sessions.Find(report.other_session)->scale(),
                        sessions.Find(report.query_session)->scale(), report.query_from_other);
  if (disagreement > kMaxScaleDisagreement) {
    report.warning = "the odometry of the two sessions disagrees about the scale by " +
                     std::to_string(disagreement) + " sigmas";
  }
  ledger_.Place();
  const MapId map = ledger_.PlaceOf(report.query_session).map;
  ledger_.RaiseRevision(map);
  for (const PlacedSession& placed : ledger_.SessionsOf(map, sessions)) {
    changed_.insert(placed.session->id());
  }
  Adjust(map, false, sessions, &report);
}

// Adjusts only what gapes: of a hundred overlaps of two laps the first matters most.
void MapMerger::CloseLoop(MergeRecord* record, const SessionTable& sessions) {
  MergeReport& report = record->report;
  const MapId map = ledger_.PlaceOf(report.query_session).map;
  const std::vector<PlacedSession> placed = ledger_.SessionsOf(map, sessions);
  const LinkStatistics before = MeasureLinks(placed, record->links);
  report.error_before_px = report.error_after_px = before.median_error_px;
  if (before.median_error_px <= options_.merge.max_gap_px) return;
  if (options_.merge.use_pose_graph) SpreadGap(placed, report, ledger_.LinksOf(map, record));
  Adjust(map, false, sessions, &report);
  report.error_before_px = before.median_error_px;
}

void MapMerger::KeepBefore(const SessionTable& sessions, MergeRecord* record) const {
  const MapId a = ledger_.PlaceOf(record->report.other_session).map;
  const MapId b = ledger_.PlaceOf(record->report.query_session).map;
  for (const auto& [id, session] : sessions.all()) {
    const MapId map = ledger_.PlaceOf(id).map;
    if (map == a || map == b) record->before[id] = std::make_shared<const Session>(*session);
  }
}

void MapMerger::Adjust(MapId map, bool is_final, const SessionTable& sessions,
                       MergeReport* report) {
  std::vector<FeatureLink> links = ledger_.LinksOf(map);
  if (links.empty()) return;
  const std::vector<PlacedSession> placed = ledger_.SessionsOf(map, sessions);
  MapAdjustmentReport adjusted = AdjustMap(placed, options_, is_final, &links);
  report->error_before_px = adjusted.before.median_error_px;
  report->error_after_px = adjusted.after.median_error_px;
  ledger_.KeepLinks(map, links);
  if (adjusted.usable) {
    shared_[map] = std::make_shared<const SharedLandmarks>(std::move(adjusted.shared));
  }
  for (const PlacedSession& session : placed) changed_.insert(session.session->id());
}

void MapMerger::AdjustFinally(const SessionTable& sessions) {
  std::set<MapId> maps;
  for (const auto& [id, session] : sessions.all()) maps.insert(ledger_.PlaceOf(id).map);
  MergeReport unused;
  for (const MapId map : maps) Adjust(map, true, sessions, &unused);
}

void MapMerger::GiveUpWaiting() {
  for (const Waiting& waiting : waiting_) GiveUp(waiting);
  waiting_.clear();
}

void MapMerger::GiveUp(const Waiting& waiting) {
  MergeRecord record;
  record.report.verdict = MergeVerdict::kRefused;
  record.report.query = waiting.match.query;
  record.report.other = waiting.match.pairs.front().other;
  record.report.reason = "waited in vain: " + waiting.reason;
  ledger_.Keep(std::move(record));
}

std::vector<MergeReport> MapMerger::Reports() const {
  std::vector<MergeReport> reports;
  for (const MergeRecord& record : ledger_.records()) reports.push_back(record.report);
  return reports;
}

std::vector<PlaceMatch> MapMerger::WaitingFor(const DriveId& drive) const {
  std::vector<PlaceMatch> matches;
  for (const Waiting& waiting : waiting_) {
    if (waiting.match.query.drive == drive) matches.push_back(waiting.match);
  }
  return matches;
}

bool MapMerger::IsSeparated(SessionId a, SessionId b) const {
  return separated_.count({std::min(a, b), std::max(a, b)}) != 0;
}

}  // namespace rovio_sfm
