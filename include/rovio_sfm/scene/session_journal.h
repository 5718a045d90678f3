#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/scene/session_parts.h"
#include "rovio_sfm/scene/track_positions.h"

namespace rovio_sfm {

// What a session was at a mark, as far as it changed before the next one: the values that were
// replaced, oldest first. What was born since is known by its stamps and needs no entry.
struct SessionEpoch {
  struct PoseBefore {
    uint32_t frame = 0;
    bool weak = false;
    Rigid3 cam_from_session;
  };
  struct LightPoseBefore {
    uint32_t frame = 0, reference = 0, num_inliers = 0;
    Rigid3 cam_from_reference;
  };
  struct MemberBefore {
    uint32_t frame = 0, feature = 0;
    TrackId track = 0;
  };
  template <typename Key, typename Part>
  using Parts = std::vector<std::pair<Key, std::shared_ptr<const Part>>>;

  // How many bytes the entries take, without what keyframes and landmarks point to.
  size_t NumBytes() const;
  // No more entries come.
  void Shrink();

  uint32_t number = 0;
  std::optional<MapScale> scale;
  Camera camera;
  std::vector<PoseBefore> poses;
  std::vector<LightPoseBefore> light_poses;
  std::vector<MemberBefore> members;
  TrackPositions positions;
  Parts<TrackId, Landmark> landmarks;        // those whose observations changed, or that went
  Parts<uint32_t, Keyframe> keyframes;       // those that went
  Parts<uint32_t, LightFrame> light_frames;  // those that went, or were replaced
  std::vector<TrackId> aliases;              // that came
};

}  // namespace rovio_sfm
