#include "rovio_sfm/sim/world/texture_spec.h"

#include <algorithm>

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {

const std::vector<std::string>& KnownMarks() {
  static const std::vector<std::string> names = {"books",     "bricks", "chips",  "circuit",
                                                 "dials",     "holes",  "labels", "posters",
                                                 "scratches", "shapes", "text",   "tiles"};
  return names;
}

bool TextureSpec::IsValid(std::string* error) const {
  OptionChecker check("texture " + name, error);
  check.Range("width_px", width_px, 8, 4096);
  check.Range("height_px", height_px, 8, 4096);
  check.Range("texel_m", texel_m, 1e-5, 0.1);
  check.Range("contrast", contrast, 0.0, 2.0);
  check.Range("stretch", stretch, 0.02, 50.0);
  check.Range("patches", patches, 0.0, 0.9);
  check.Range("density", density, 0.0, 4.0);
  check.Range("period_px", period_px, 4.0, 1024.0);
  for (const std::string& mark : marks) {
    const auto& known = KnownMarks();
    const bool is_known = std::find(known.begin(), known.end(), mark) != known.end();
    check.True(("marks: " + mark).c_str(), is_known, "one of KnownMarks()");
  }
  return check.Passed();
}

}  // namespace rovio_sfm::sim
