#pragma once

#include <boost/container/flat_map.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

enum class SessionState : uint8_t { kBootstrapping = 0, kMapping = 1, kFinished = 2, kLost = 3 };

// How long a session's unit is. Without a source of scale (or before enough of it) nothing is
// known.
struct MapScale {
  double metres_per_unit = 1.0;
  double sigma_log = 0.0;  // 1 sigma of log(metres_per_unit)
  std::string source;      // "odometry", "camera height", or several
};

// How much later than an image of the same moment an odometry sample is stamped, beyond what the
// frontend's odom_latency_s - image_latency_s takes off. delay_s > 0: odometry comes late.
struct OdometryDelay {
  double delay_s = 0.0;
  double sigma_s = 0.0;
};

// One registered frame.
struct FrameSnapshot {
  uint32_t index = 0;  // FrameId::index in the session's drive
  int64_t stamp_ns = 0;
  std::string image_name;
  FrameKind kind = FrameKind::kKeyframe;
  bool weak = false;
  Rigid3 cam_from_session;  // map units
  std::optional<Rigid3> base_from_camera;
  uint32_t num_observations = 0;
};

struct LandmarkSnapshot {
  TrackId id = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // in the session, map units
  Rgb color{};
  uint32_t num_views = 0;
  double max_parallax_rad = 0.0;          // the widest angle under which two views see it
  double mean_error_px = 0.0;             // mean reprojection error over its views
  double squared_error_normalized = 0.0;  // sum over its views of |residual|^2 on the plane z = 1
};

// Blocks are shared between snapshots as long as nothing in them changes.
using FrameBlock = std::vector<FrameSnapshot>;
using LandmarkBlock = std::vector<LandmarkSnapshot>;

struct SessionSnapshot {
  SessionId id;
  uint64_t revision = 0;  // Session::revision(); neither tells of the map it lies in
  MapId map;
  uint32_t gauge_revision = 0;
  DriveId drive;
  Camera given_camera, camera;  // that the frames came with, and that they are mapped by
  SessionState state = SessionState::kBootstrapping;
  std::optional<MapScale> scale;                          // of the session's unit; none: not metric
  std::optional<OdometryDelay> odometry_delay;            // of one that ended, where its turns tell
  Sim3 map_from_session;                                  // identity for a map's root session
  std::vector<std::shared_ptr<const FrameBlock>> frames;  // by increasing index
  std::vector<std::shared_ptr<const LandmarkBlock>> landmarks;  // by increasing id
};

// The landmarks that links join, each with a number: those with the same one are one point.
using SharedLandmarks = boost::container::flat_map<std::pair<SessionId, TrackId>, uint32_t>;

// An immutable picture of all maps at one moment.
struct MapSnapshot {
  uint64_t version = 0;                   // raised with every snapshot
  std::vector<SessionSnapshot> sessions;  // by id
  // As the map was last adjusted; what is gone since, or in another map, does not count.
  std::map<MapId, std::shared_ptr<const SharedLandmarks>> shared_landmarks;
};

// The frame `<session>/map` (§3 of the design) from the session's own gauge: base_link at the first
// registered frame whose head's pose is known (of the first block of frames), x forward, z up, in
// metres if the session has a scale, else in map units. Where none is known, the first frame's
// camera is taken as pitched down by camera_pitch_rad. Nothing for a session without frames.
std::optional<Sim3> LevelFromSession(const SessionSnapshot& session, double camera_pitch_rad = 0.0);

}  // namespace rovio_sfm
