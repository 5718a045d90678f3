#include "rovio_sfm/app/changed_parts.h"

#include <tuple>
#include <utility>

#include "rovio_sfm/report/level_session.h"

namespace rovio_sfm {
namespace {

bool IsDrawn(const MergeReport& report) {
  return report.verdict == MergeVerdict::kAccepted || report.verdict == MergeVerdict::kProvisional;
}

// Adds the other sessions of all overlaps that are drawn.
void AddOthers(const std::vector<MergeReport>& merges, std::set<SessionId>* others) {
  for (const MergeReport& report : merges) {
    if (IsDrawn(report)) others->insert(report.other_session);
  }
}

// The other sessions of drawn overlaps at one of the sessions that changed.
void AddTouched(const std::vector<MergeReport>& merges, const SessionChanges& changes,
                std::set<SessionId>* others) {
  std::set<SessionId> touched(changes.sessions.begin(), changes.sessions.end());
  touched.insert(changes.gone.begin(), changes.gone.end());
  for (const MergeReport& report : merges) {
    const bool is_touched =
        touched.count(report.query_session) > 0 || touched.count(report.other_session) > 0;
    if (is_touched && IsDrawn(report)) others->insert(report.other_session);
  }
}

std::map<CloudPlace, MapStamp> CloudStamps(const MapPicture& picture) {
  std::set<MapId> with_frames;
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    if (!session.frames.empty()) with_frames.insert(session.map);
  }
  const SessionSnapshot* root = FindRoot(*picture.snapshot);
  std::map<CloudPlace, MapStamp> stamps;
  auto by_map = MapStamps(picture);
  for (auto& [id, stamp] : by_map) {
    const bool is_root = root != nullptr && root->map == id;
    if (with_frames.count(id) > 0) stamps[{is_root, id}] = std::move(stamp);
  }
  return stamps;
}

}  // namespace

bool operator==(const SessionStamp& a, const SessionStamp& b) {
  return std::tie(a.epoch, a.id, a.revision, a.map, a.gauge_revision, a.map_from_session,
                  a.metres_per_unit) == std::tie(b.epoch, b.id, b.revision, b.map, b.gauge_revision,
                                                 b.map_from_session, b.metres_per_unit);
}

SessionStamp StampOf(const MapPicture& picture, const SessionSnapshot& session) {
  return {picture.epoch,
          session.id,
          session.revision,
          session.map,
          session.gauge_revision,
          session.map_from_session,
          session.scale ? session.scale->metres_per_unit : 0.0};
}

bool operator==(const MapStamp& a, const MapStamp& b) {
  return a.sessions == b.sessions && a.shared_landmarks == b.shared_landmarks;
}

std::map<MapId, MapStamp> MapStamps(const MapPicture& picture) {
  std::map<MapId, MapStamp> stamps;
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    stamps[session.map].sessions.push_back(StampOf(picture, session));
  }
  for (const auto& [id, shared] : picture.snapshot->shared_landmarks) {
    const auto stamp = stamps.find(id);
    if (stamp != stamps.end()) stamp->second.shared_landmarks = shared;
  }
  return stamps;
}

bool operator<(const CloudPlace& a, const CloudPlace& b) {
  // The root map is shown in one place, whichever map it is.
  if (a.is_root || b.is_root) return a.is_root && !b.is_root;
  return a.map < b.map;
}

SessionChanges ChangedParts::TakeSessions(const MapPicture& picture) {
  SessionChanges changes;
  auto last = std::exchange(sessions_, {});
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    const SessionStamp stamp = StampOf(picture, session);
    sessions_[session.id] = stamp;
    const auto before = last.find(session.id);
    const bool is_same = before != last.end() && before->second == stamp;
    if (!is_same) changes.sessions.push_back(session.id);
    if (before != last.end()) last.erase(before);
  }
  for (const auto& [id, stamp] : last) changes.gone.push_back(id);
  const Reports merges_before = std::exchange(merges_, picture.merges);
  if (merges_before == merges_) {
    AddTouched(*merges_, changes, &changes.overlaps);
  } else {
    if (merges_before) AddOthers(*merges_before, &changes.overlaps);
    AddOthers(*merges_, &changes.overlaps);
  }
  return changes;
}

CloudChanges ChangedParts::TakeClouds(const MapPicture& picture) {
  CloudChanges changes;
  const auto last = std::exchange(clouds_, CloudStamps(picture));
  for (const auto& [place, stamp] : clouds_) {
    const auto before = last.find(place);
    if (before == last.end() || !(before->second == stamp)) changes.clouds.push_back(place);
  }
  for (const auto& [place, stamp] : last) {
    if (clouds_.count(place) == 0) changes.gone.push_back(place);
  }
  return changes;
}

bool ChangedParts::TakeGauges(const MapPicture& picture) {
  std::vector<SessionStamp> gauges;
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    gauges.push_back(StampOf(picture, session));
    gauges.back().revision = 0;
  }
  const auto last = std::exchange(gauges_, gauges);
  return !(last == gauges_);
}

}  // namespace rovio_sfm
