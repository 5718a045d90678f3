#pragma once

#include <optional>
#include <vector>

#include "rovio_sfm/io/export_ply.h"
#include "rovio_sfm/io/trajectory_file.h"
#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// One map of a snapshot in its level frame: x forward, z up, metres if it has a scale, else map
// units.
struct LevelMap {
  MapId id;
  std::optional<MapScale> scale;  // none: lengths are map units
  Sim3 level_from_map;
  std::vector<SessionSnapshot> sessions;                    // of this map, by id
  std::shared_ptr<const SharedLandmarks> shared_landmarks;  // null: none
};

// A registered image; weak poses (§3.7.1) are not among them.
struct PosedImage {
  FrameId id;
  FrameKind kind = FrameKind::kKeyframe;
  StampedPose level_from_camera;
};

// The map with the given id, or the one that holds most registered images. Nothing where there is
// no such map with a frame.
std::optional<LevelMap> FindLevelMap(const MapSnapshot& snapshot, MapId id);
std::optional<LevelMap> FindLargestMap(const MapSnapshot& snapshot);

// All maps with a registered image, the largest first, the older one of two as large.
std::vector<LevelMap> FindMapsBySize(const MapSnapshot& snapshot);

// By drive, then by index.
std::vector<PosedImage> PosedImages(const LevelMap& map);

// A landmark counts with two or more views, 1.5 degrees of parallax and at most 4 px of mean error.
bool IsCounted(const LandmarkSnapshot& landmark);

// A landmark of the map, and the session in whose gauge it stands.
struct MapLandmark {
  const SessionSnapshot* session = nullptr;  // of the map that was asked
  LandmarkSnapshot landmark;
};

// All landmarks, by session and id. Those that links join are one: it stands where the first of
// them does, and has the views of all.
std::vector<MapLandmark> UniteLandmarks(const LevelMap& map);

// The landmarks that count, in the level frame, by session and id.
std::vector<CloudPoint> LevelCloud(const LevelMap& map);

}  // namespace rovio_sfm
