#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "rovio_sfm/app/mapping_engine.h"

namespace rovio_sfm {

// All that what is shown of a session depends on: equal stamps, equal pictures. The epoch keeps
// sessions apart that have one number because all maps were forgotten in between.
struct SessionStamp {
  uint64_t epoch = 0;
  SessionId id;
  uint64_t revision = 0;  // of the session itself
  MapId map;
  uint32_t gauge_revision = 0;
  Sim3 map_from_session;
  double metres_per_unit = 0.0;  // 0: not metric
};
bool operator==(const SessionStamp& a, const SessionStamp& b);
SessionStamp StampOf(const MapPicture& picture, const SessionSnapshot& session);

// Likewise of a map.
struct MapStamp {
  std::vector<SessionStamp> sessions;  // by id
  std::shared_ptr<const SharedLandmarks> shared_landmarks;
};
bool operator==(const MapStamp& a, const MapStamp& b);
std::map<MapId, MapStamp> MapStamps(const MapPicture& picture);

struct SessionChanges {
  std::vector<SessionId> sessions;  // new, or other than before
  std::vector<SessionId> gone;
  std::set<SessionId> overlaps;  // those whose overlaps (as the other session) are not as before
};

// Where a map is shown: the root map apart from all others.
struct CloudPlace {
  bool is_root = false;
  MapId map;
};
bool operator<(const CloudPlace& a, const CloudPlace& b);

struct CloudChanges {
  std::vector<CloudPlace> clouds;  // new, or other than before
  std::vector<CloudPlace> gone;    // to be cleared: no map is shown there any more
};

// What differs between one picture of the maps and the last that was taken, by stamps alone: what
// it costs does not depend on how large the maps are. Sessions, clouds and gauges are taken apart,
// each at its own pace. Thread-compatible.
class ChangedParts {
 public:
  SessionChanges TakeSessions(const MapPicture& picture);
  // Maps without a frame are shown nowhere.
  CloudChanges TakeClouds(const MapPicture& picture);
  // Whether what joins the sessions' frames, or their unit, is another than before.
  bool TakeGauges(const MapPicture& picture);

 private:
  using Reports = std::shared_ptr<const std::vector<MergeReport>>;

  std::map<SessionId, SessionStamp> sessions_;
  Reports merges_;
  std::map<CloudPlace, MapStamp> clouds_;
  std::vector<SessionStamp> gauges_;  // without revisions
};

}  // namespace rovio_sfm
