#pragma once

#include <cstdint>
#include <string>

namespace rovio_sfm {

// "1 image", "2 images".
inline std::string CountText(uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// "1 image was", "2 images were".
inline std::string CountWere(uint64_t count, const std::string& noun) {
  return CountText(count, noun) + (count == 1 ? " was" : " were");
}

}  // namespace rovio_sfm
