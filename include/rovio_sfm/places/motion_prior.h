#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/places/fabmap.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

struct MotionPriorOptions {
  double move_probability = 2.0 / 3.0;
  double uniform_share = 0.1;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("move_probability", move_probability, 0.0, 1.0, "to a place's neighbours");
    table.AddNumber("uniform_share", uniform_share, 0.001, 1.0,
                    "spread over all places, so that none is ruled out");
  }
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
