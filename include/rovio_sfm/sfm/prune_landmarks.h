#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/landmark_limits.h"

namespace rovio_sfm {

struct PruneReport {
  uint32_t num_observations = 0;  // removed, with those of removed landmarks
  uint32_t num_landmarks = 0;     // removed
  uint32_t num_frames = 0;        // keyframes removed
};

// Removes observations with a larger reprojection error (tau_r, §3.8) or behind their camera, then
// landmarks that are left with fewer than two views or with too little parallax; of the given
// tracks (those without a landmark are passed over), or of all.
PruneReport PruneLandmarks(const std::vector<TrackId>& tracks, const LandmarkLimits& limits,
                           Session* session);

// Prunes all landmarks, and then removes the keyframes that no longer hang on the largest part of
// the session by ten landmarks: nothing holds their poses any more, and least of all their scale.
PruneReport PruneAllLandmarks(const LandmarkLimits& limits, Session* session);

// The robust spread of the reprojection errors, in sigmas: 1.4826 times the median of the
// residuals' components. Zero for a session without landmarks.
double ResidualSpread(const Session& session);

}  // namespace rovio_sfm
