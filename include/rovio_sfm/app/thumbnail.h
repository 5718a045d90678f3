#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rovio_sfm {

// A small JPEG of an encoded picture (JPEG or PNG), at most so wide, px. Nothing where it cannot be
// decoded; `error` says why.
std::optional<std::string> ThumbnailOf(const std::vector<uint8_t>& encoded, int max_width,
                                       std::string* error);

}  // namespace rovio_sfm
