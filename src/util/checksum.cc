#include "rovio_sfm/util/checksum.h"

#include <zlib.h>

namespace rovio_sfm {

uint32_t Checksum(const uint8_t* data, size_t size) {
  return static_cast<uint32_t>(crc32_z(crc32_z(0, nullptr, 0), data, size));
}

}  // namespace rovio_sfm
