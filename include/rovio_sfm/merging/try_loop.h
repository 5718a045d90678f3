#pragma once

#include <optional>
#include <vector>

#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/merging/try_overlap.h"

namespace rovio_sfm {

// Tries a place match between two sessions of one map, or within one, against the map as it is: the
// links that it means, where most of them fit within options.merge.max_gap_px already. Nothing
// where they do not, or are fewer than a resection needs: then the overlap has something to say,
// and TryOverlap must judge it. pairs: those of the match whose frames are in session a.
std::optional<OverlapTrial> TryLoop(const PlacedSession& a, const PlacedSession& b,
                                    const FrameId& query, const std::vector<OverlapPair>& pairs,
                                    const MapOptions& options);

}  // namespace rovio_sfm
