#pragma once

#include <algorithm>
#include <vector>

#include "merging/two_drives.h"
#include "rovio_sfm/merging/map_bundle.h"

namespace rovio_sfm {

// Two mapped drives of one world in two gauges, linked where three pairs of keyframes overlap.
struct MergedPair {
  explicit MergedPair(double noise_px = 0.0)
      : two(MakeTwoDrives(TwoDrivesOptions(noise_px))),
        a(MappedSession(two, false, {})),
        b(MappedSession(two, true, OtherGauge())),
        placed{{&a, {}}, {&b, Inverse(OtherGauge())}} {
    for (const uint32_t frame : {3u, 8u, 12u}) {
      const std::vector<FeatureLink> more = LinksOf(TrueOverlap(two, frame, frame), a.id(), b.id());
      links.insert(links.end(), more.begin(), more.end());
    }
    std::sort(links.begin(), links.end());
  }

  // The largest distance of a camera of b from its true place, with a as the gauge.
  double ErrorOfB() const {
    double worst = 0.0;
    for (const auto& [index, frame] : b.keyframes()) {
      worst = std::max(worst, PoseDistance(CamFromMap(placed[1], index),
                                           two.world.cams_from_map[CameraOf(true, index)]));
    }
    return worst;
  }

  TwoDrives two;
  Session a, b;
  std::vector<PlacedSession> placed;
  std::vector<FeatureLink> links;
};

}  // namespace rovio_sfm
