#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// The second pass of §5.1.5: features that the first left unmatched, along the epipolar band.
struct GuidedOptions {
  double band_px = 2.0;      // half width of the band, in b; 0.1 to 20
  float max_ratio = 0.9f;    // looser than the first pass, among the features of the band; 0.1 to 1
  float max_factor = 1.25f;  // distance <= factor * mean distance of the known matches; 0.1 to 10
  // Points nearer than this many baselines are not looked for; 0 to 100
  double min_depth_baselines = 1.0;

  bool IsValid(std::string* error) const;
};

// One-to-one matches between the features of a and b that `known` does not use, in order of b.
// Empty without known matches, for a pose without translation, or where the descriptors' types
// differ. focal_px turns pixels into the plane z = 1.
std::vector<FeatureMatch> MatchGuided(const FrameFeatures& a, const FrameFeatures& b,
                                      const Rigid3& b_from_a,
                                      const std::vector<FeatureMatch>& known, double focal_px,
                                      const GuidedOptions& options);

}  // namespace rovio_sfm
