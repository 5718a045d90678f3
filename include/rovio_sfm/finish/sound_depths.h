#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/matching/match_in_range.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

struct SoundDepthOptions {
  size_t num_neighbors = 5;  // sound points nearest in the picture
  double max_ratio = 1.1;    // beyond the nearest or farthest of them
};

// How deep the points of a model lie that are sound: the first num_trusted, and those of three
// views and more. Borrows nothing; may be read by several threads.
class SoundDepths {
 public:
  static constexpr size_t kNoPoint = SIZE_MAX;

  SoundDepths(const MapModel& model, size_t num_trusted, const SoundDepthOptions& options);

  // From the nearest to the farthest of the sound points round a place of an image (plane z = 1),
  // with some room; skipped is left out. Unknown where the image sees too few.
  DepthRange Around(uint32_t image, const Eigen::Vector2d& x_normalized,
                    size_t skipped = kNoPoint) const;

 private:
  struct SeenPoint {
    size_t point = 0;
    Eigen::Vector2d x_normalized;
    double depth = 0.0;
  };

  SoundDepthOptions options_;
  std::vector<std::vector<SeenPoint>> seen_;  // by image
};

// Removes added points, those from num_trusted on, that lie outside the range round them in the
// image that sees them from nearest: so do most wrong matches along an epipolar line. Returns how
// many.
size_t RemoveInconsistentDepths(size_t num_trusted, const SoundDepthOptions& options,
                                MapModel* model);

}  // namespace rovio_sfm
