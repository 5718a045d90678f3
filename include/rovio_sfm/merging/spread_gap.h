#pragma once

#include <vector>

#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/merge_report.h"

namespace rovio_sfm {

// Spreads the gap that a loop shows over the frames of its map by a Sim(3) pose graph (Strasdat
// 2010; the drift of scale of §5.3.1): nodes are keyframes, edges join neighbours as they stand and
// the two frames of the loop as it was measured; frames that links join already stay together.
// Landmarks move with the first frame that sees them. The first frame of the first session stays.
// False, with nothing changed, where the graph cannot be solved or refutes the loop.
bool SpreadGap(const std::vector<PlacedSession>& sessions, const MergeReport& loop,
               const std::vector<FeatureLink>& links);

}  // namespace rovio_sfm
