#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/features/denoise.h"
#include "rovio_sfm/features/extract_options.h"
#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

struct GatherOptions {
  int64_t max_pixels = 32'000'000;  // larger pictures are refused
  DenoiseOptions denoise;
  ExtractOptions extract;   // type, budget and corners are set
  int max_features = 4000;  // of a picture (§3.9), or twice the stored ones where that is more
  double min_distance_px = 2.0;  // a found feature nearer to a stored one is left out
};

// The stored features of an image, in their order, and after them those found in its picture with
// the larger budget, SIFT's with corners where the picture has too few extrema to fill it; the
// stored ones alone where there is no picture (null). Throws std::runtime_error where the picture
// cannot be read or has another size than its camera.
FrameFeatures GatherFeatures(const FrameFeatures& stored, const std::vector<uint8_t>* picture,
                             const Camera& camera, const GatherOptions& options);

}  // namespace rovio_sfm
