#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/scene/feature_link.h"

namespace rovio_sfm {

// How well links hold: every landmark at one end, seen in the frame of the other end.
struct LinkStatistics {
  uint32_t num_links = 0;        // of registered keyframes, with a landmark at one end at least
  double median_error_px = 0.0;  // of the landmarks seen across
};

LinkStatistics MeasureLinks(const std::vector<PlacedSession>& sessions,
                            const std::vector<FeatureLink>& links);

struct MapAdjustmentReport {
  bool usable = false;  // false: no pose was changed
  LinkStatistics before, after;
  uint32_t num_dropped_links = 0;
  SharedLandmarks shared;  // what the links that hold have made one point
};

// Adjusts all frames and landmarks of all sessions of a map as one problem (§4.3.3), prunes
// observations as the final adjustment of a session does, and drops links that do not fit. The
// first session holds the gauge. is_final: rounds until little changes, the last one without the
// robust loss.
MapAdjustmentReport AdjustMap(const std::vector<PlacedSession>& sessions,
                              const MapperOptions& options, bool is_final,
                              std::vector<FeatureLink>* links);

}  // namespace rovio_sfm
