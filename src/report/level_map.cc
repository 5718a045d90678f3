#include "rovio_sfm/report/level_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr double kMinParallaxRad = Radians(1.5);
constexpr double kMaxErrorPx = 4.0;

size_t NumRegistered(const SessionSnapshot& session) {
  size_t count = 0;
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) count += frame.weak ? 0 : 1;
  }
  return count;
}

std::map<MapId, size_t> NumRegisteredByMap(const MapSnapshot& snapshot) {
  std::map<MapId, size_t> num_registered;
  for (const SessionSnapshot& session : snapshot.sessions) {
    num_registered[session.map] += NumRegistered(session);
  }
  return num_registered;
}

void AddViews(const LandmarkSnapshot& more, LandmarkSnapshot* landmark) {
  const double error_px =
      landmark->mean_error_px * landmark->num_views + more.mean_error_px * more.num_views;
  landmark->num_views += more.num_views;
  landmark->mean_error_px = error_px / landmark->num_views;
  landmark->squared_error_normalized += more.squared_error_normalized;
  landmark->max_parallax_rad = std::max(landmark->max_parallax_rad, more.max_parallax_rad);
}

}  // namespace

std::optional<LevelMap> FindLevelMap(const MapSnapshot& snapshot, MapId id) {
  LevelMap map;
  map.id = id;
  for (const SessionSnapshot& session : snapshot.sessions) {
    if (session.map == id) map.sessions.push_back(session);
  }
  if (map.sessions.empty()) return std::nullopt;
  const SessionSnapshot& root = map.sessions.front();
  const std::optional<Sim3> level_from_session = LevelFromSession(root);
  if (!level_from_session) return std::nullopt;
  map.scale = root.scale;
  map.level_from_map = *level_from_session * Inverse(root.map_from_session);
  const auto shared = snapshot.shared_landmarks.find(id);
  if (shared != snapshot.shared_landmarks.end()) map.shared_landmarks = shared->second;
  return map;
}

std::optional<LevelMap> FindLargestMap(const MapSnapshot& snapshot) {
  const std::map<MapId, size_t> num_registered = NumRegisteredByMap(snapshot);
  const auto largest =
      std::max_element(num_registered.begin(), num_registered.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (largest == num_registered.end()) return std::nullopt;
  return FindLevelMap(snapshot, largest->first);
}

std::vector<LevelMap> FindMapsBySize(const MapSnapshot& snapshot) {
  const std::map<MapId, size_t> num_registered = NumRegisteredByMap(snapshot);
  std::vector<std::pair<MapId, size_t>> sizes(num_registered.begin(), num_registered.end());
  std::stable_sort(sizes.begin(), sizes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<LevelMap> maps;
  for (const auto& [id, size] : sizes) {
    if (size == 0) continue;
    if (auto map = FindLevelMap(snapshot, id)) maps.push_back(std::move(*map));
  }
  return maps;
}

std::vector<PosedImage> PosedImages(const LevelMap& map) {
  std::vector<PosedImage> images;
  for (const SessionSnapshot& session : map.sessions) {
    const Sim3 level_from_session = map.level_from_map * session.map_from_session;
    for (const auto& block : session.frames) {
      for (const FrameSnapshot& frame : *block) {
        if (frame.weak) continue;
        const Rigid3 cam_from_level = TransformCamera(level_from_session, frame.cam_from_session);
        images.push_back(
            {{session.drive, frame.index}, frame.kind, {frame.stamp_ns, Inverse(cam_from_level)}});
      }
    }
  }
  std::sort(images.begin(), images.end(),
            [](const PosedImage& a, const PosedImage& b) { return a.id < b.id; });
  return images;
}

bool IsCounted(const LandmarkSnapshot& landmark) {
  return landmark.num_views >= 2 && landmark.max_parallax_rad >= kMinParallaxRad &&
         landmark.mean_error_px <= kMaxErrorPx;
}

std::vector<MapLandmark> UniteLandmarks(const LevelMap& map) {
  const SharedLandmarks nothing;
  const SharedLandmarks& shared = map.shared_landmarks ? *map.shared_landmarks : nothing;
  std::unordered_map<uint32_t, size_t> place_of;  // in the list, of the points that are shared
  std::vector<MapLandmark> landmarks;
  for (const SessionSnapshot& session : map.sessions) {
    for (const auto& block : session.landmarks) {
      for (const LandmarkSnapshot& landmark : *block) {
        const auto point = shared.find({session.id, landmark.id});
        if (point == shared.end() || place_of.emplace(point->second, landmarks.size()).second) {
          landmarks.push_back({&session, landmark});
        } else {
          AddViews(landmark, &landmarks[place_of.at(point->second)].landmark);
        }
      }
    }
  }
  return landmarks;
}

std::vector<CloudPoint> LevelCloud(const LevelMap& map) {
  std::map<SessionId, Sim3> level_from_sessions;
  for (const SessionSnapshot& session : map.sessions) {
    level_from_sessions[session.id] = map.level_from_map * session.map_from_session;
  }
  std::vector<CloudPoint> cloud;
  for (const auto& [session, landmark] : UniteLandmarks(map)) {
    if (!IsCounted(landmark)) continue;
    cloud.push_back({level_from_sessions.at(session->id) * landmark.position, landmark.color,
                     session->id.value, landmark.num_views,
                     static_cast<float>(landmark.mean_error_px)});
  }
  return cloud;
}

}  // namespace rovio_sfm
