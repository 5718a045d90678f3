#pragma once

#include <string_view>

namespace rovio_sfm {

// As std::string's starts_with and ends_with of C++20.
inline bool StartsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

inline bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace rovio_sfm
