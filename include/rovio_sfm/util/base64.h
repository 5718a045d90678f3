#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace rovio_sfm {

// RFC 4648, padded.
std::string Base64(const std::vector<uint8_t>& bytes);

// Of the values' bytes as they lie in memory: little-endian.
template <typename Value>
std::string Base64Of(const std::vector<Value>& values) {
  std::vector<uint8_t> bytes(values.size() * sizeof(Value));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return Base64(bytes);
}

}  // namespace rovio_sfm
