#include "rovio_sfm/merging/confirm_overlap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

using LandmarkSet = std::set<std::pair<SessionId, TrackId>>;

// The landmarks that the overlap links, of both sessions.
LandmarkSet LandmarksOf(const MergeEdit& edit, const SessionTable& sessions) {
  LandmarkSet landmarks;
  for (const FeatureLink& link : edit.links.List()) {
    for (const FeatureRef& feature : {link.a, link.b}) {
      const Session* session = sessions.Find(feature.session);
      if (session == nullptr || ObservedLandmark(*session, feature) == nullptr) continue;
      landmarks.insert({feature.session, session->keyframe(feature.frame).tracks[feature.feature]});
    }
  }
  return landmarks;
}

double SharedShare(const MergeEdit& x, const MergeEdit& y, const SessionTable& sessions) {
  const LandmarkSet of_x = LandmarksOf(x, sessions), of_y = LandmarksOf(y, sessions);
  size_t shared = 0;
  for (const auto& landmark : of_x) shared += of_y.count(landmark);
  const size_t smaller = std::min(of_x.size(), of_y.size());
  return smaller == 0 ? 1.0 : static_cast<double>(shared) / static_cast<double>(smaller);
}

// What another overlap says of where the edit's sessions lie; nothing if it joins other maps.
std::optional<Sim3> SaidBy(const MergeReport& other, const MergeReport& mine,
                           const MergeList& list) {
  const MapPlace a = list.PlaceOf(mine.other_session), b = list.PlaceOf(mine.query_session);
  const MapPlace c = list.PlaceOf(other.other_session), d = list.PlaceOf(other.query_session);
  Sim3 map_b_from_map_a = d.map_from_session * other.query_from_other * Inverse(c.map_from_session);
  if (c.map == b.map && d.map == a.map) {
    map_b_from_map_a = Inverse(map_b_from_map_a);
  } else if (!(c.map == a.map && d.map == b.map)) {
    return std::nullopt;
  }
  return Inverse(b.map_from_session) * map_b_from_map_a * a.map_from_session;
}

}  // namespace

bool IsSmall(const LoopGap& gap, const MergeOptions& options) {
  return std::abs(gap.log_scale) <= options.max_scale_gap &&
         gap.rotation_rad <= Radians(options.max_rotation_gap_deg);
}

LoopStatement MeasureLoop(const MergeReport& report, const MergeList& list,
                          const SessionTable& sessions) {
  const Session &a = *sessions.Find(report.other_session),
                &b = *sessions.Find(report.query_session);
  const Sim3 known_b_from_a =
      Inverse(list.PlaceOf(b.id()).map_from_session) * list.PlaceOf(a.id()).map_from_session;
  LoopStatement statement;
  statement.gap = MeasureGap(b, report.query.index, report.query_from_other, known_b_from_a);
  if (a.id() == b.id()) {
    statement.way = PathLength(b, std::min(report.query.index, report.other.index),
                               std::max(report.query.index, report.other.index));
  } else {
    statement.way =
        PathLength(b, 0, UINT32_MAX) + known_b_from_a.scale * PathLength(a, 0, UINT32_MAX);
  }
  return statement;
}

MergeEdit* FindConfirmation(const MergeEdit& edit, const MergeOptions& options,
                            const SessionTable& sessions, MergeList* list) {
  const MergeReport& mine = edit.report;
  const Session& query = *sessions.Find(mine.query_session);
  const double max_distance = options.max_scale_gap * MedianDepth(query, mine.query.index);
  for (MergeEdit& other : list->edits()) {
    if (other.report.verdict != MergeVerdict::kProvisional || &other == &edit) continue;
    const std::optional<Sim3> said = SaidBy(other.report, mine, *list);
    if (!said) continue;
    const LoopGap gap = MeasureGap(query, mine.query.index, mine.query_from_other, *said);
    if (!IsSmall(gap, options) || gap.distance > max_distance) continue;
    if (SharedShare(edit, other, sessions) <= options.max_shared_landmarks) return &other;
  }
  return nullptr;
}

}  // namespace rovio_sfm
