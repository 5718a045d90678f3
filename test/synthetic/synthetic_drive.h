#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {

struct SyntheticDriveOptions {
  SyntheticOptions world = DefaultWorld();
  int light_frames = 0;  // after each keyframe
  int track_length = 0;  // cameras after which a point goes on in another track; 0: one track each
  bool with_links = false;       // the next frame links the two tracks
  std::set<uint32_t> blind;      // keyframes whose features are in no known track
  bool with_late_links = false;  // the frame after a blind one links its tracks
  std::optional<uint32_t> cut;   // no track and no pair reaches from before into this frame
  std::optional<double> metres_per_unit;  // with odometry, where it is given
  double odometry_gain = 1.0;             // measured by travelled way

  // 16 cameras, 0.3 map units apart, on a circle of 4 round the middle of 250 points.
  static SyntheticOptions DefaultWorld();
};

// The events of a drive through a synthetic world, as a perfect frontend would send them: event i
// is camera i, its track ids come from the points, each keyframe is paired with the one before.
struct SyntheticDrive {
  SyntheticWorld world;
  std::vector<FrameEvent> events;
};

SyntheticDrive MakeSyntheticDrive(const SyntheticDriveOptions& options);

// The poses of a mapped drive against the true ones.
struct TrajectoryError {
  size_t num_frames = 0;
  double max_distance = 0.0;      // of the centres in map units of the world, best similarity
  double max_rotation_rad = 0.0;  // after it
};

// Nothing for fewer than three frames that are not weak.
std::optional<TrajectoryError> MeasureTrajectory(const SessionSnapshot& session,
                                                 const SyntheticWorld& world);

// All numbers of a snapshot but its version, byte by byte.
std::string BytesOf(const MapSnapshot& snapshot);

}  // namespace rovio_sfm
