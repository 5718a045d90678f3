#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/scene/session_parts.h"

namespace rovio_sfm {

constexpr uint64_t kFramesPerBlock = 64;
constexpr uint64_t kLandmarksPerBlock = 1024;

// Blocks by number: frame index / kFramesPerBlock, landmark id / kLandmarksPerBlock.
using FrameBlocks = std::map<uint64_t, std::shared_ptr<const FrameBlock>>;
using LandmarkBlocks = std::map<uint64_t, std::shared_ptr<const LandmarkBlock>>;

// Make the blocks of a session that are missing from the cache, keep the others, and return all in
// order.
std::vector<std::shared_ptr<const FrameBlock>> UpdateFrameBlocks(
    const std::map<uint32_t, Keyframe>& keyframes,
    const std::map<uint32_t, LightFrame>& light_frames, FrameBlocks* cache);
std::vector<std::shared_ptr<const LandmarkBlock>> UpdateLandmarkBlocks(
    const Camera& camera, const std::map<uint32_t, Keyframe>& keyframes,
    const std::map<TrackId, Landmark>& landmarks, LandmarkBlocks* cache);

}  // namespace rovio_sfm
