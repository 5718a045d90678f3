#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sessions/align_sessions.h"

namespace rovio_sfm {

// Where the query's session (b) lies against the other one (a).
struct OverlapAlignment {
  std::optional<SessionAlignment> alignment;  // b_from_a
  std::string reason;                         // why there is none
  bool needs_scale = false;  // there would be one if both sessions knew their scale
  std::vector<CrossMatch> inliers;
  int num_matches = 0, num_common = 0;  // of the input
};

// Aligns two mapped sessions by what a query frame of b shares with frames of a (§4.3): 3D-3D from
// common landmarks; else the query is resected among a's landmarks and the depths of its own give
// the scale; else, where both sessions are metric, their odometry does; else frames of a are
// resected among b's landmarks, and their distance, or a's landmarks in the query, gives it.
// pairs: all of session a.
OverlapAlignment AlignOverlap(const Session& a, const Session& b, uint32_t query,
                              const std::vector<OverlapPair>& pairs, const MapOptions& options);

// Refines an alignment with links found by searching (search_across.h).
OverlapAlignment AlignLinks(const Session& a, const Session& b,
                            const std::vector<FeatureLink>& links, const Sim3& b_from_a,
                            const MapOptions& options);

}  // namespace rovio_sfm
