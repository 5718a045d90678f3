#pragma once

#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// How deep a feature's point may lie in its camera, map units. far = 0: nothing is known.
struct DepthRange {
  double near = 0.0, far = 0.0;

  bool Contains(double depth) const { return depth >= near && depth <= far; }
};

struct RangeMatchOptions {
  double band_px = 2.0;           // greatest distance from the stretch of the epipolar line
  float max_ratio = 0.9f;         // Lowe's, among the features of the stretch
  float max_factor = 1.25f;       // of the known matches' mean distance
  int sample_step = 0;            // every so many of a's other features are a sample; 0: no sample
  float max_sample_ratio = 0.9f;  // Lowe's, to the sample's features off the stretch
};

// One-to-one matches between the features of a and b that `known` does not use, in order of b: a
// feature of b with a depth range is looked for along that stretch of its epipolar line in a. The
// more features an image has, the more of a stretch look right by chance: what looks no more alike
// than some feature of a sample from elsewhere is not taken.
// ranges_in_b: by feature of b. Empty without known matches or where the descriptors' types differ.
// focal_px turns pixels into the plane z = 1.
std::vector<FeatureMatch> MatchInRange(const FrameFeatures& a, const FrameFeatures& b,
                                       const Rigid3& b_from_a,
                                       const std::vector<DepthRange>& ranges_in_b,
                                       const std::vector<FeatureMatch>& known, double focal_px,
                                       const RangeMatchOptions& options);

}  // namespace rovio_sfm
