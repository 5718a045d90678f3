#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

class Session;

constexpr uint64_t kFramesPerBlock = 64;
constexpr uint64_t kLandmarksPerBlock = 1024;

// Blocks by number: frame index / kFramesPerBlock, landmark id / kLandmarksPerBlock.
using FrameBlocks = std::map<uint64_t, std::shared_ptr<const FrameBlock>>;
using LandmarkBlocks = std::map<uint64_t, std::shared_ptr<const LandmarkBlock>>;

// Makes the blocks that are missing from the cache, keeps the others, and returns all in order.
std::vector<std::shared_ptr<const FrameBlock>> UpdateFrameBlocks(const Session& session,
                                                                 FrameBlocks* cache);
std::vector<std::shared_ptr<const LandmarkBlock>> UpdateLandmarkBlocks(const Session& session,
                                                                       LandmarkBlocks* cache);

}  // namespace rovio_sfm
