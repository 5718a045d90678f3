#pragma once

#include <vector>

#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// What an overlap would join, and how well it is proven.
struct OverlapTrial {
  bool needs_scale = false;  // refused, but may be aligned once both sessions know their scale
  MergeReport report;        // verdict: accepted, provisional or refused; nothing was changed yet
  std::vector<FeatureLink> links;  // a: of the other session, b: of the query's; sorted
};

// Tries a place match between two mapped sessions (§4.3): aligns them, searches landmarks across
// around the overlap, aligns again with what was found, and judges the evidence. pairs: those of
// the match whose frames are in session a.
OverlapTrial TryOverlap(const Session& a, const Session& b, const FrameId& query,
                        const std::vector<OverlapPair>& pairs, const MapOptions& options,
                        const FrameStore& store);

}  // namespace rovio_sfm
