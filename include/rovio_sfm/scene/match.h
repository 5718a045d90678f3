#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// Feature a of an earlier frame and feature b of a later one show the same point, by appearance.
struct FeatureMatch {
  uint32_t a = 0;
  uint32_t b = 0;
  float distance = 0.0f;  // in the descriptor's metric
  float ratio = 1.0f;     // best distance / second best, for PROSAC
};

// What the geometry of a matched pair turned out to be.
enum class PairVerdict : uint8_t { kFailed = 0, kGeneral = 1, kPlanar = 2, kRotation = 3 };

// How many matches were left after each filter (Table 3.2).
struct MatchCounts {
  uint32_t features = 0;    // of the later frame
  uint32_t ratio = 0;       // after Lowe's ratio
  uint32_t percentile = 0;  // after the percentile filter (§3.4.2)
  uint32_t one_to_one = 0;
  uint32_t ransac = 0;  // after RANSAC on the essential matrix (§3.5)
  uint32_t guided = 0;  // after the guided pass; equal to ransac where it is off
};

// One matched pair (other frame, this frame), as a FrameEvent carries it.
struct PairMatches {
  uint32_t other_index = 0;  // FrameId::index of the earlier frame, same drive
  MatchCounts counts;
  PairVerdict verdict = PairVerdict::kFailed;
  Rigid3 cam_from_other;              // this camera from the other; translation has length 1 or 0
  double median_parallax_rad = 0;     // after removing the rotation
  std::vector<FeatureMatch> inliers;  // a: the other frame's feature, b: this frame's
};

}  // namespace rovio_sfm
