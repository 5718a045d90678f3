#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace rovio_sfm {

// A feature of a keyframe that belongs to a track.
struct TrackMember {
  uint32_t frame = 0;    // FrameId::index
  uint32_t feature = 0;  // of that frame
  Eigen::Vector2f x_px = Eigen::Vector2f::Zero();
};

// Filter f1 (§3.6): true if one track can hold the members of both, that is, if in every frame that
// both have, their features are the same or nearer than max_distance_px (§6.2). Members are sorted
// by frame.
bool PassesFilterF1(const std::vector<TrackMember>& members_a,
                    const std::vector<TrackMember>& members_b, double max_distance_px);

}  // namespace rovio_sfm
