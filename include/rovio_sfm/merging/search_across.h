#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// Where a session's landmarks are looked for in a frame of another one.
struct SearchAcrossOptions {
  double radius_px = 8.0;         // of the window round a predicted pixel
  double max_error_sigmas = 6.0;  // a found feature must project that well
  float max_distance = 320.0f;    // of byte descriptors (L2, RootSIFT of length 512)
  float max_ratio = 0.9f;         // to the second best feature of the window
  // A landmark should be visible in a frame that looks at it from where a frame of its own session
  // did: within this angle and this ratio of distances, and inside the image by the radius.
  double max_view_angle_rad = 0.35;
  double max_distance_ratio = 1.5;
  int min_views = 3;  // of a landmark whose absence says something

  // Names the field, its value and its bound.
  bool IsValid(std::string* error) const;
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
};

// Projects the landmarks of session a that frames of the range see into a keyframe of session b by
// a similarity and looks for each by its descriptor (§4.3.1, matching around an overlap, guided).
// a and b may be one session: landmarks that the frame observes already count as found, without
// a link.
AcrossReport SearchAcross(const Session& a, const FrameRange& range_a, const Session& b,
                          uint32_t frame_b, const Sim3& b_from_a,
                          const SearchAcrossOptions& options, const FrameStore& store);

}  // namespace rovio_sfm
