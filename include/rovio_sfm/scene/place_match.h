#pragma once

#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// A frame that shows the place of the query frame, by appearance and epipolar geometry.
struct OverlapPair {
  FrameId other;
  PairVerdict verdict = PairVerdict::kFailed;
  Rigid3 query_from_other;            // cameras; translation of length 1, or 0 for a rotation
  std::vector<FeatureMatch> inliers;  // a: the other frame's feature, b: the query's
};

// A row of the thesis's table T (§4.3.1): a keyframe and the earlier known keyframes, of another
// drive or of its own, that show the same place.
struct PlaceMatch {
  FrameId query;
  double probability = 0.0;        // posterior of the best place
  double score = 0.0;              // log(sum of place likelihoods / likelihood of a new place)
  std::vector<OverlapPair> pairs;  // the matched frame first, then frames around it; never empty
};

}  // namespace rovio_sfm
