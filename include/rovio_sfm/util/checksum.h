#pragma once

#include <cstddef>
#include <cstdint>

namespace rovio_sfm {

// CRC-32 as of zlib and PNG.
uint32_t Checksum(const uint8_t* data, size_t size);

}  // namespace rovio_sfm
