#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/adjust_bundle.h"

namespace rovio_sfm {

// A part of a session as a bundle problem, and which frame and track each entry stands for.
struct SessionBundle {
  BundleProblem problem;
  std::vector<uint32_t> frames;  // of problem.cameras
  std::vector<TrackId> tracks;   // of problem.points
};

// The keyframes most covisible with `frame` (itself first), by the number of shared landmarks, ties
// by index; at most max_count, and none with fewer than min_shared.
std::vector<uint32_t> CovisibleFrames(const Session& session, uint32_t frame, size_t max_count,
                                      uint32_t min_shared);

// The landmarks that the free frames see, with every frame that sees them: the others are fixed, at
// most max_fixed of them (the most covisible).
SessionBundle MakeLocalBundle(const Session& session, const std::vector<uint32_t>& free_frames,
                              size_t max_fixed);

// All keyframes that are not weak, and all landmarks.
SessionBundle MakeGlobalBundle(const Session& session);

// Writes poses and positions back, by id: frames and landmarks that are gone are skipped. Keyframes
// and landmarks that the bundle does not know move with the correction of their reference: the
// newest keyframe of the bundle before them (for a landmark: before its first view). A local bundle
// must not move what it does not know: move_others false.
void ApplyBundle(const SessionBundle& bundle, bool move_others, Session* session);

}  // namespace rovio_sfm
