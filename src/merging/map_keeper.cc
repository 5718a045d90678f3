#include "rovio_sfm/merging/map_keeper.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "rovio_sfm/merging/adjust_map.h"
#include "rovio_sfm/merging/confirm_overlap.h"
#include "rovio_sfm/merging/group_pairs.h"
#include "rovio_sfm/merging/share_scales.h"
#include "rovio_sfm/merging/spread_gap.h"
#include "rovio_sfm/merging/try_loop.h"

namespace rovio_sfm {
namespace {

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

bool Joins(const MergeReport& report, SessionId a, SessionId b) {
  const SessionId x = report.other_session, y = report.query_session;
  return (x == a && y == b) || (x == b && y == a);
}

MergeReport RefusedReport(SessionId a, SessionId b, const std::string& reason) {
  MergeReport report;
  report.verdict = MergeVerdict::kRefused;
  report.other_session = a;
  report.query_session = b;
  report.reason = reason;
  return report;
}

// Whether a request may accept what was judged so.
bool IsPossible(MergeVerdict verdict, bool force) {
  return verdict == MergeVerdict::kProvisional || verdict == MergeVerdict::kUndone ||
         (force && verdict == MergeVerdict::kRefused);
}

}  // namespace

MapKeeper::MapKeeper(const MapOptions& options, const FrameStore* store, Executor* executor,
                     ResultTiming timing, StageTimes* times)
    : options_(options), store_(store), executor_(executor), timing_(timing), times_(times) {}

void MapKeeper::Add(const PlaceMatch& match) {
  const FrameId& other = match.pairs.front().other;
  if (list_.HasJudged(match.query, other) || waiting_.HoldsBoth(match.query, other)) {
    ++num_repeated_;  // as place recognition tells again after a restart
    return;
  }
  WaitingMatch entry{match, 0, "", false};
  if (TryNow(&entry)) return;
  waiting_.Add(std::move(entry), [this](const WaitingMatch& old) { KeepWaitedInVain(old); });
}

void MapKeeper::Advance() {
  waiting_.Advance(
      options_.merge.patience, [this](WaitingMatch* entry) { return TryNow(entry); },
      [this](const WaitingMatch& old) { KeepWaitedInVain(old); });
}

// False, and why, where the match must wait.
bool MapKeeper::TryNow(WaitingMatch* entry) {
  const PlaceMatch& match = entry->match;
  const Session* query = sessions_.FindHolder(match.query);
  const PairsBySession pairs = GroupPairs(match, sessions_);
  if (query == nullptr || pairs.empty()) {
    const FrameId& missing = query == nullptr ? match.query : match.pairs.front().other;
    entry->reason = "frame " + missing.ToString() + " has no pose";
    return false;
  }
  const Session& other = *sessions_.Find(FindRichest(pairs));
  if (!IsRipe(*query, options_.merge) || !IsRipe(other, options_.merge)) {
    entry->reason = "a session has too few keyframes";
    return false;
  }
  const int max_overlaps = options_.merge.max_overlaps;
  const bool used_up =
      max_overlaps > 0 && list_.CountAccepted(match.query.drive, other.drive()) >= max_overlaps;
  if (used_up || list_.IsSeparated(query->id(), other.id())) return true;
  const std::vector<OverlapPair>& of_other = pairs.at(other.id());
  if (auto trial = TryLink(match, other.id(), query->id(), of_other)) {
    MergeEdit& edit = list_.Keep(match, std::move(*trial));
    list_.Accept(AcceptedBy::kEvidence, &edit);
    return true;
  }
  const bool scale_may_come = MayGetScale(*query) || MayGetScale(other);
  if (entry->needs_scale && scale_may_come) return false;
  if (running_.count(list_.PlaceOf(query->id()).map) != 0 &&
      list_.AreInOneMap(query->id(), other.id())) {
    entry->reason = "its map is being adjusted";  // then it may fit
    return false;
  }
  OverlapTrial trial = TryOverlap(other, *query, match.query, of_other, options_, *store_);
  entry->needs_scale = trial.needs_scale && scale_may_come;
  entry->reason = trial.report.reason;
  if (entry->needs_scale) return false;
  Judge(match, std::move(trial));
  return true;
}

// An overlap within one map that fits it as it is only adds its links.
std::optional<OverlapTrial> MapKeeper::TryLink(const PlaceMatch& match, SessionId a, SessionId b,
                                               const std::vector<OverlapPair>& pairs) {
  if (!list_.AreInOneMap(a, b)) return std::nullopt;
  return TryLoop({sessions_.Lend(a), list_.PlaceOf(a).map_from_session},
                 {sessions_.Lend(b), list_.PlaceOf(b).map_from_session}, match.query, pairs,
                 options_);
}

void MapKeeper::Judge(const PlaceMatch& match, OverlapTrial trial) {
  MergeEdit& edit = list_.Keep(match, std::move(trial));
  MergeReport& report = edit.report;
  if (report.verdict == MergeVerdict::kRefused) return;
  if (list_.AreInOneMap(report.other_session, report.query_session)) {
    // What the map says already needs no more proof; what contradicts it needs all.
    report.kind = MergeKind::kLoop;
    const LoopStatement loop = MeasureLoop(report, list_, sessions_);
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
  if (report.verdict == MergeVerdict::kAccepted) return Accept(AcceptedBy::kEvidence, &edit);
  MergeEdit* other = FindConfirmation(edit, options_.merge, sessions_, &list_);
  if (other == nullptr) return;
  report.reason = "confirmed by overlap " + std::to_string(other->report.id);
  other->report.reason = "confirmed by overlap " + std::to_string(report.id);
  Accept(AcceptedBy::kSecondOverlap, other);
  Accept(AcceptedBy::kSecondOverlap, &edit);
}

void MapKeeper::Accept(AcceptedBy by, MergeEdit* edit) {
  MergeReport& report = edit->report;
  list_.Accept(by, edit);
  if (list_.AreInOneMap(report.other_session, report.query_session)) {
    report.kind = MergeKind::kLoop;
    return CloseLoop(edit);
  }
  MarkSessions(edit);
  const double disagreement =
      ScaleDisagreement(sessions_.Find(report.other_session)->scale(),
                        sessions_.Find(report.query_session)->scale(), report.query_from_other);
  if (disagreement > kMaxScaleDisagreement) {
    report.warning = "the odometry of the two sessions disagrees about the scale by " +
                     std::to_string(disagreement) + " sigmas";
  }
  running_.erase(list_.PlaceOf(report.other_session).map);
  running_.erase(list_.PlaceOf(report.query_session).map);
  list_.Place();
  const MapId map = list_.PlaceOf(report.query_session).map;
  list_.RaiseRevision(map);
  const std::vector<PlacedSession> placed = list_.SessionsOf(map, &sessions_);
  report.error_before_px = MeasureLinks(placed, edit->links.List()).median_error_px;
  StartAdjusting(map, *edit);
}

// What the sessions of both maps are before they become one.
void MapKeeper::MarkSessions(MergeEdit* edit) {
  for (const SessionId side : {edit->report.other_session, edit->report.query_session}) {
    for (const SessionId id : list_.MembersOf(list_.PlaceOf(side).map, sessions_)) {
      edit->marks[id] = sessions_.Lend(id)->Mark();
    }
  }
}

// Adjusts only what gapes: of a hundred overlaps of two laps the first matters most.
void MapKeeper::CloseLoop(MergeEdit* edit) {
  MergeReport& report = edit->report;
  const MapId map = list_.PlaceOf(report.query_session).map;
  const std::vector<PlacedSession> placed = list_.SessionsOf(map, &sessions_);
  const LinkStatistics before = MeasureLinks(placed, edit->links.List());
  report.error_before_px = before.median_error_px;
  if (before.median_error_px <= options_.merge.max_gap_px) return;
  if (options_.merge.use_pose_graph) SpreadGap(placed, report, list_.LinksOf(map, edit));
  StartAdjusting(map, *edit);
}

// What runs on the map is thrown away: it knows nothing of this edit.
void MapKeeper::StartAdjusting(MapId map, const MergeEdit& edit) {
  running_.erase(map);
  const auto scope = MeasureStage(times_, "adjust_map");
  const std::vector<FeatureLink> links = list_.LinksOf(map);
  if (links.empty()) return;
  const std::vector<PlacedSession> placed = list_.SessionsOf(map, &sessions_);
  num_frames_at_last_[map] = NumFrames(placed);
  running_.emplace(
      map, Running{MapAdjustment(placed, links, options_, executor_, timing_), edit.report.id});
}

// As often as a session that no links join is adjusted by its own drive.
void MapKeeper::AdjustGrownMaps() {
  const double growth = 1.0 + options_.adjust.global_growth;
  for (const MapId map : list_.LinkedMaps()) {
    const size_t num_frames = NumFrames(list_.SessionsOf(map, &sessions_));
    size_t& at_last = num_frames_at_last_.try_emplace(map, num_frames).first->second;
    at_last = std::min(at_last, num_frames);  // sessions may have left the map
    if (static_cast<double>(num_frames) > growth * static_cast<double>(at_last)) AdjustAgain(map);
  }
}

void MapKeeper::CountKeyframe() {
  for (auto& [map, running] : running_) running.adjustment.CountKeyframe();
  ApplyDueResults();
  AdjustGrownMaps();
}

bool MapKeeper::ApplyDueResults() {
  std::vector<MapId> due;
  for (const auto& [map, running] : running_) {
    if (running.adjustment.IsDue()) due.push_back(map);
  }
  for (const MapId map : due) ApplyAdjustment(map);
  return !due.empty();
}

void MapKeeper::ApplyAdjustment(MapId map) {
  const auto scope = MeasureStage(times_, "adjust_map");
  Running running = std::move(running_.extract(map).mapped());
  std::vector<FeatureLink> links = list_.LinksOf(map);
  const MapAdjustmentReport report = running.adjustment.Apply(options_, &links, times_);
  list_.edits()[running.edit - 1].report.error_after_px = report.after.median_error_px;
  TakeOver(map, report, links);
}

void MapKeeper::TakeOver(MapId map, MapAdjustmentReport report,
                         const std::vector<FeatureLink>& links) {
  list_.KeepLinks(map, links);
  if (!report.usable) return;
  shared_[map] = std::make_shared<const SharedLandmarks>(std::move(report.shared));
}

void MapKeeper::AdjustMapOf(MapId map) {
  running_.erase(map);
  std::vector<FeatureLink> links = list_.LinksOf(map);
  if (links.empty()) return;
  TakeOver(map, AdjustMapFinally(list_.SessionsOf(map, &sessions_), options_, &links), links);
}

void MapKeeper::AdjustAllFinally() {
  for (const MapId map : list_.LinkedMaps()) AdjustMapOf(map);
  Advance();  // what waited for an adjustment may fit now
  for (const MapId map : list_.LinkedMaps()) {
    if (running_.count(map) != 0) AdjustMapOf(map);
  }
}

MergeReport MapKeeper::Merge(SessionId a, SessionId b, bool force) {
  if (list_.AreInOneMap(a, b)) {
    return RefusedReport(a, b, "they are in one map already");
  }
  MergeEdit* best = nullptr;
  for (MergeEdit& edit : list_.edits()) {
    if (!IsPossible(edit.report.verdict, force) || !Joins(edit.report, a, b)) continue;
    if (edit.report.num_inliers == 0) continue;
    if (best == nullptr || edit.report.num_inliers > best->report.num_inliers) best = &edit;
  }
  if (best == nullptr) return RefusedReport(a, b, "no overlap of these sessions is known");
  list_.AllowJoining(a, b, sessions_);
  best->report.kind = MergeKind::kMerge;
  best->report.reason = "accepted by request";
  Accept(AcceptedBy::kRequest, best);
  return best->report;
}

MergeReport MapKeeper::MergeAt(SessionId a, SessionId b, const Sim3& b_from_a) {
  if (list_.AreInOneMap(a, b)) {
    return RefusedReport(a, b, "they are in one map already");
  }
  MergeEdit edit;
  edit.report.other_session = a;
  edit.report.query_session = b;
  edit.report.query_from_other = b_from_a;
  edit.report.reason = "placed by request";
  MergeEdit& kept = list_.Keep(std::move(edit));
  list_.AllowJoining(a, b, sessions_);
  Accept(AcceptedBy::kHand, &kept);
  return kept.report;
}

void MapKeeper::KeepWaitedInVain(const WaitingMatch& waiting) {
  MergeEdit edit;
  edit.report.verdict = MergeVerdict::kRefused;
  edit.report.query = waiting.match.query;
  edit.report.other = waiting.match.pairs.front().other;
  edit.report.reason = "waited in vain: " + waiting.reason;
  list_.Keep(std::move(edit));
}

std::vector<MergeReport> MapKeeper::Reports() const {
  std::vector<MergeReport> reports;
  for (const MergeEdit& edit : list_.edits()) reports.push_back(edit.report);
  return reports;
}

}  // namespace rovio_sfm
