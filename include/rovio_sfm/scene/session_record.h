#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/session_journal.h"
#include "rovio_sfm/scene/session_parts.h"

namespace rovio_sfm {

// All that a session consists of, as it is kept on disk. What features observe stands in the
// landmarks alone; tracks' members stand in the frames.
struct SessionRecord {
  SessionId id;
  DriveId drive;
  Camera camera;                         // that the frames came with
  std::optional<Camera> refined_camera;  // that their features are normalised by, if another one
  SessionState state = SessionState::kBootstrapping;
  std::optional<MapScale> scale;
  std::optional<OdometryDelay> odometry_delay;
  std::map<uint32_t, Keyframe> keyframes;
  std::map<uint32_t, LightFrame> light_frames;
  std::map<TrackId, Landmark> landmarks;
  std::unordered_map<TrackId, TrackId> aliases;  // to the track that it was united with
  std::vector<SessionEpoch> epochs;
  uint32_t num_marks = 0;
};

}  // namespace rovio_sfm
