#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// Fewer shared tracks are no overlap of two frames.
constexpr size_t kMinSharedTracks = 12;

// The overlaps of two sessions of one drive, of which `before` was lost, that the frontend's own
// matches make: for each keyframe of `after` those of `before` that show the same tracks, most
// first. Empty where none share kMinSharedTracks.
std::vector<PlaceMatch> MatchAcrossBreak(const Session& before, const Session& after);

// Tracks that both keyframes show; none where the sessions are of two drives.
size_t CountSharedTracks(const Session& a, uint32_t frame_a, const Session& b, uint32_t frame_b);

}  // namespace rovio_sfm
