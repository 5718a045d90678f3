#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

struct StationaryOptions {
  int64_t rest_ns = 300000000;

  void DescribeOptions(OptionTable& table) {
    table.AddSeconds("stationary_rest_s", rest_ns, 0.0, 10.0,
                     "the wheels must have rested so long before an image counts");
  }
};

// Chooses the images of a robot that drives, stops and looks: one image per stop, taken when the
// wheels have rested. Before the first motion there is one, too. Stamps in ns. Not thread-safe.
class StationaryTrigger {
 public:
  explicit StationaryTrigger(const StationaryOptions& options) : options_(options) {}

  // Tells whether the wheels turn, or are told to, at this time.
  void Note(bool is_moving, int64_t now_ns);

  // Whether an image taken now would be the one of this stop.
  bool WantsImage(int64_t now_ns) const;

  // True for the one image of this stop, by the stamp of its first byte; it is then done with.
  bool Accept(int64_t stamp_ns);

 private:
  const StationaryOptions options_;
  bool is_known_ = false;  // a Note has come
  bool is_moving_ = false;
  bool has_image_ = false;  // of this stop
  int64_t rest_since_ns_ = 0;
};

}  // namespace rovio_sfm
