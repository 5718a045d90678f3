#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The second pass of §5.1.5: features that the first left unmatched, along the epipolar band.
struct GuidedOptions {
  double band_px = 2.0;
  float max_ratio = 0.9f;
  float max_factor = 1.25f;
  double min_depth_baselines = 1.0;

  void DescribeOptions(OptionTable& table) {
    table.AddLiveNumber("band_px", band_px, 0.1, 20.0, "half width of the band");
    table.AddNumber("max_ratio", max_ratio, 0.1, 1.0, "Lowe's, among the features of the band");
    table.AddNumber("max_factor", max_factor, 0.1, 10.0, "of the known matches' mean distance");
    table.AddNumber("min_depth_baselines", min_depth_baselines, 0.0, 100.0, "nearer is not sought");
  }
};

// One-to-one matches between the features of a and b that `known` does not use, in order of b.
// Empty without known matches, for a pose without translation, or where the descriptors' types
// differ. focal_px turns pixels into the plane z = 1.
std::vector<FeatureMatch> MatchGuided(const FrameFeatures& a, const FrameFeatures& b,
                                      const Rigid3& b_from_a,
                                      const std::vector<FeatureMatch>& known, double focal_px,
                                      const GuidedOptions& options);

}  // namespace rovio_sfm
