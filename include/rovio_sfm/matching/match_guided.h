#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/matching/match_in_range.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The second pass of §5.1.5: features that the first left unmatched, along the part of the epipolar
// line where the depths of known matches round them say they are.
struct GuidedOptions {
  RangeMatchOptions range{2.0, 0.8f, 1.6f, 8, 0.9f};
  int few_known = 100;
  float few_factor = 2.0f;
  int neighbors = 8;
  double max_depth_ratio = 1.3;

  void DescribeOptions(OptionTable& table) {
    table.AddLiveNumber("band_px", range.band_px, 0.1, 20.0, "half width of the band");
    table.AddNumber("max_ratio", range.max_ratio, 0.1, 1.0,
                    "Lowe's, among the features of the band");
    table.AddNumber("max_factor", range.max_factor, 0.1, 10.0,
                    "of the known matches' mean distance");
    table.AddNumber("few_known", few_known, 0, 100000, "known matches; fewer: few_factor instead");
    table.AddNumber("few_factor", few_factor, 0.1, 10.0,
                    "of the mean distance: false matches harm less than a lost frame");
    table.AddNumber("sample_step", range.sample_step, 0, 1000,
                    "every so many features elsewhere must look less alike; 0: none");
    table.AddNumber("max_sample_ratio", range.max_sample_ratio, 0.1, 1.0, "Lowe's, to those");
    table.AddNumber("neighbors", neighbors, 1, 1000, "known matches whose depths bound the band");
    table.AddNumber("max_depth_ratio", max_depth_ratio, 1.0, 100.0,
                    "beyond the nearest or farthest of them");
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
