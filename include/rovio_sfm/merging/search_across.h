#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Where a session's landmarks are looked for in a frame of another one.
struct SearchAcrossOptions {
  double radius_px = 8.0;
  double max_error_sigmas = 6.0;
  float max_distance = 320.0f;
  float max_ratio = 0.9f;
  // A landmark should be visible in a frame that looks at it from where a frame of its own session
  // did, and inside the image by the radius.
  double max_view_angle_rad = 0.35;
  double max_wide_angle_rad = 1.05;
  double max_distance_ratio = 1.5;
  int min_views = 3;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("radius_px", radius_px, 1.0, 100.0, "of the window round a predicted pixel");
    table.AddNumber("max_error_sigmas", max_error_sigmas, 1.0, 100.0, "of a found feature");
    table.AddNumber("max_distance", max_distance, 1.0, 1000.0, "of byte descriptors, L2");
    table.AddNumber("max_ratio", max_ratio, 0.1, 1.0, "to the second best feature of the window");
    table.AddNumber("max_view_angle_rad", max_view_angle_rad, 0.01, 1.5,
                    "visible from within this angle of a view of it");
    table.AddNumber("max_wide_angle_rad", max_wide_angle_rad, 0.01, 1.5,
                    "may be visible: found it counts, absent it says nothing");
    table.AddRule("max_wide_angle_rad", max_wide_angle_rad >= max_view_angle_rad,
                  "at least max_view_angle_rad");
    table.AddNumber("max_distance_ratio", max_distance_ratio, 1.0, 10.0, "and ratio of distances");
    table.AddNumber("min_views", min_views, 2, 100, "of a landmark whose absence says something");
  }
};

// Keyframes of a session from first to last.
struct FrameRange {
  uint32_t first = 0;
  uint32_t last = UINT32_MAX;
};

// What a frame of session b shows of the landmarks of session a.
struct AcrossReport {
  std::vector<FeatureLink> links;  // a: a view of the landmark, b: the frame's feature; sorted by a
  uint32_t num_expected = 0;       // landmarks of a that should be visible
  uint32_t num_found = 0;          // of them, those that were found
  // The same of landmarks of any number of views, from up to max_wide_angle_rad away.
  uint32_t num_wide = 0;
  uint32_t num_wide_found = 0;
};

// Projects the landmarks of session a that frames of the range see into a keyframe of session b by
// a similarity and looks for each by its descriptor (§4.3.1, matching around an overlap, guided).
// a and b may be one session: landmarks that the frame observes already count as found, without
// a link.
AcrossReport SearchAcross(const Session& a, const FrameRange& range_a, const Session& b,
                          uint32_t frame_b, const Sim3& b_from_a,
                          const SearchAcrossOptions& options, const FrameStore& store);

}  // namespace rovio_sfm
