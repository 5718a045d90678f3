#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rovio_sfm/mapping/delayed_result.h"
#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {

// How well links hold: every landmark at one end, seen in the frame of the other end.
struct LinkStatistics {
  uint32_t num_links = 0;        // of registered keyframes, with a landmark at one end at least
  double median_error_px = 0.0;  // of the landmarks seen across
};

LinkStatistics MeasureLinks(const std::vector<PlacedSession>& sessions,
                            const std::vector<FeatureLink>& links);

size_t NumFrames(const std::vector<PlacedSession>& sessions);

struct MapAdjustmentReport {
  bool usable = false;    // false: no pose was changed
  LinkStatistics before;  // final adjustments only
  LinkStatistics after;
  uint32_t num_dropped_links = 0;
  SharedLandmarks shared;  // what the links that hold have made one point
};

// Adjusts all frames and landmarks of all sessions of a map as one problem (§4.3.3), prunes
// observations as the final adjustment of a session does, and drops links that do not fit: rounds
// until little changes; and all of that again by other calibrations where the pictures tell them
// (AdjustWithCamera). The first session holds the gauge.
MapAdjustmentReport AdjustMapFinally(const std::vector<PlacedSession>& sessions,
                                     const MapperOptions& options, std::vector<FeatureLink>* links);

// The landmarks that these links make one point, of a map that is adjusted already.
SharedLandmarks FindSharedLandmarks(const std::vector<PlacedSession>& sessions,
                                    const std::vector<FeatureLink>& links,
                                    const MapperOptions& options);

// One round of the same beside the flow: a copy is solved in the executor. Frames and landmarks
// born since move with the correction of their reference frame.
class MapAdjustment {
 public:
  // Starts it. The executor must outlive the solving; the sessions must outlive this.
  MapAdjustment(const std::vector<PlacedSession>& sessions, const std::vector<FeatureLink>& links,
                const MapperOptions& options, Executor* executor, ResultTiming timing);

  void CountKeyframe() { result_.CountKeyframe(); }
  bool IsDue() const { return result_.IsDue(); }
  // Writes the result into the sessions, waiting for it where it is not there. links: those of the
  // map as they are by now.
  MapAdjustmentReport Apply(const MapperOptions& options, std::vector<FeatureLink>* links,
                            StageTimes* times = nullptr);

 private:
  std::vector<PlacedSession> sessions_;
  DelayedResult<std::unique_ptr<MapBundle>> result_;  // null: not usable
};

}  // namespace rovio_sfm
