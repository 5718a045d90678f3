#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace rovio_sfm {

// A name from a request that can lead out of no folder: 1 to 64 of A-Z a-z 0-9 _ - ., not beginning
// with a dot.
inline bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= 64 && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
         });
}

}  // namespace rovio_sfm
