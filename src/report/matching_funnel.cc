#include "rovio_sfm/report/matching_funnel.h"

namespace rovio_sfm {

void AddToFunnel(const FrameEvent& event, MatchingFunnel* funnel) {
  if (event.pairs.empty()) return;
  const MatchCounts& counts = event.pairs.front().counts;
  ++funnel->pairs;
  funnel->features += counts.features;
  funnel->ratio += counts.ratio;
  funnel->percentile += counts.percentile;
  funnel->one_to_one += counts.one_to_one;
  funnel->ransac += counts.ransac;
  funnel->guided += counts.guided;
}

}  // namespace rovio_sfm
