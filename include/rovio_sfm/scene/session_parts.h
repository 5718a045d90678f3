#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// In which epoch a part of a session was born, and first moved or changed otherwise. 0: before the
// first mark.
struct EpochStamps {
  uint32_t born = 0, moved = 0, changed = 0;
};

// Feature `feature` of the session's frame `frame` (FrameId::index).
struct Observation {
  uint32_t frame = 0;
  uint32_t feature = 0;
};
inline bool operator==(const Observation& a, const Observation& b) {
  return a.frame == b.frame && a.feature == b.feature;
}
inline bool operator<(const Observation& a, const Observation& b) {
  return a.frame != b.frame ? a.frame < b.frame : a.feature < b.feature;
}

// The features that should show one point: all matches, whether or not they agree with a landmark.
struct Track {
  std::vector<Observation> members;  // keyframes only; sorted, one per frame
};

// A point of the map and the members of its track that agree with it.
struct Landmark {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // in the session, map units
  Rgb color{};
  std::vector<Observation> observations;  // sorted, one per frame, a subset of the track's members
  EpochStamps stamps;                     // of the session's journal
};

// A registered keyframe.
struct Keyframe {
  int64_t stamp_ns = 0;
  std::string image_name;
  bool weak = false;  // its pose is a guess from its neighbour: no triangulation, no reference
  Rigid3 cam_from_session;
  std::optional<OdometrySample> odometry;
  std::optional<Rigid3> base_from_camera;
  std::vector<Eigen::Vector2d> points;  // normalised, one per feature
  std::vector<double> sigmas;           // of a feature's position, normalised units
  std::vector<Rgb> colors;              // one per feature
  std::vector<TrackId> tracks;          // one per feature, 0 none; always roots of the alias table
  std::vector<uint8_t> observed;        // 1 where the feature observes the landmark of its track
  uint32_t num_observed = 0;
  EpochStamps stamps;  // of the session's journal
};

// A registered light frame: it only has a pose, kept relative to its reference keyframe so that it
// moves with it, and what it saw, so that it can be resected again.
struct LightFrame {
  int64_t stamp_ns = 0;
  std::string image_name;
  uint32_t reference = 0;  // index of a keyframe of the session
  Rigid3 cam_from_reference;
  std::optional<Rigid3> base_from_camera;
  std::vector<TrackId> tracks;
  std::vector<Eigen::Vector2d> points;  // normalised
  uint32_t num_inliers = 0;
  EpochStamps stamps;  // of the session's journal
};

}  // namespace rovio_sfm
