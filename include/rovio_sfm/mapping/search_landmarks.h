#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/tracks/filter_f2.h"

namespace rovio_sfm {

struct SearchLandmarksOptions {
  double radius_px = 8.0;         // of the window round a predicted pixel
  double max_error_sigmas = 4.0;  // a found feature must project that well
  float max_distance = 300.0f;    // of byte descriptors (L2, RootSIFT of length 512)
  float max_ratio = 0.9f;         // to the second best feature of the window
  size_t max_frames = 20;         // covisible frames whose landmarks are looked for
  FilterF2Options f2;             // for landmarks that are found to be one
};

struct SearchReport {
  uint32_t num_candidates = 0;  // landmarks that project into the frame and are not observed there
  uint32_t num_added = 0;       // observations added
  uint32_t num_united = 0;      // landmarks found to be the same
};

// Projects the landmarks that covisible keyframes see into the frame and looks for each in a small
// window by its descriptor (L2 types; others are left alone): new observations, and unions of
// landmarks that are one point. This is where tracks that matching has cut grow together again.
SearchReport SearchLandmarks(uint32_t frame, const SearchLandmarksOptions& options,
                             const FrameStore& store, Session* session);

}  // namespace rovio_sfm
