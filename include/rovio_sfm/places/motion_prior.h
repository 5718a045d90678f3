#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/places/fabmap.h"

namespace rovio_sfm {

struct MotionPriorOptions {
  // Share of the mass of a place that moves on to its neighbours in its drive, in equal parts; the
  // rest stays; 0 to 1.
  double move_probability = 2.0 / 3.0;
  // Share of the prior spread evenly over all places, so that no place is ruled out; 0.001 to 1.
  double uniform_share = 0.1;

  bool IsValid(std::string* error) const;
};

// Which places follow each other in a drive, and what a result says about where the robot's next
// image may be. Mass of the new place is spread evenly. Thread-compatible.
class MotionPrior {
 public:
  explicit MotionPrior(const MotionPriorOptions& options) : options_(options) {}

  // The next place (ids count from 0); `previous` is the place before it in its drive, or kNoPlace.
  static constexpr uint32_t kNoPlace = 0xffffffffu;
  void AddPlace(uint32_t previous);

  // Weights for PlaceQuery::place_weights, summing to 1, over all places added so far, of which
  // `last` knew the first ones. Empty if there is no place.
  std::vector<double> Predict(const FabmapResult& last) const;

 private:
  MotionPriorOptions options_;
  std::vector<uint32_t> previous_;  // of each place
  std::vector<uint32_t> next_;
};

}  // namespace rovio_sfm
