#pragma once

#include <vector>

#include "rovio_sfm/sessions/find_common_landmarks.h"
#include "synthetic/two_sessions.h"

namespace rovio_sfm {

// What the sessions know about the matches of two keyframes, so large a share of them false.
inline std::vector<CrossMatch> MakeCrossMatches(const TwoSessions& sessions, uint32_t keyframe_a,
                                                uint32_t keyframe_b, double outlier_share = 0.0) {
  Rng rng(11);
  return FindCrossMatches(
      sessions.a, sessions.b, {sessions.a.drive(), keyframe_a}, {sessions.b.drive(), keyframe_b},
      CrossFeatureMatches(sessions, keyframe_a, keyframe_b, outlier_share, rng));
}

}  // namespace rovio_sfm
