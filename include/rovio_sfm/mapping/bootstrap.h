#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// Two held frames from which a session can start.
struct BootstrapPair {
  size_t first = 0, second = 0;  // into the held frames
  Rigid3 second_from_first;      // translation of length 1
  double angle_rad = 0.0;        // median over the min_inliers points seen under the widest angles
  size_t num_inliers = 0;
};

// Tests pairs (h, newest) of the held keyframes over their common tracks, the oldest h first:
// enough inliers, verdict general, angle at least min_angle (§3.7). The angle is that of the
// min_inliers best points, since a robot that drives forward sees most of the room under a small
// one. The first pair that reaches the wished angle, else the one with the widest angle; nothing if
// none will do. `aliases` knows the roots of linked tracks.
std::optional<BootstrapPair> FindBootstrapPair(const std::deque<FrameEvent>& held,
                                               const Session& aliases,
                                               const BootstrapOptions& options, uint64_t seed);

// The same over all pairs of the held frames, or of 20 spread evenly over them where more are held
// (a robot that stands still), for a drive that ends before its session has started.
std::optional<BootstrapPair> FindBestBootstrapPair(const std::deque<FrameEvent>& held,
                                                   const Session& aliases,
                                                   const BootstrapOptions& options, uint64_t seed);

}  // namespace rovio_sfm
