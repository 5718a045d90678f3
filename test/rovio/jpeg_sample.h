#pragma once

#include <string>

namespace rovio_sfm {

// Markers and segment lengths of a baseline JPEG of this size, with made-up tables and scan bytes:
// enough for everything that does not decode. `filler` is repeated in the scan.
inline std::string JpegSample(int width_px, int height_px, char filler = 'x',
                              size_t scan_bytes = 200) {
  const auto word = [](int value) {
    return std::string{static_cast<char>(value / 256), static_cast<char>(value % 256)};
  };
  const std::string frame_header = std::string("\xFF\xC0", 2) + word(11) + '\x08' +
                                   word(height_px) + word(width_px) +
                                   std::string("\x01\x01\x11\x00", 4);
  const std::string scan_header =
      std::string("\xFF\xDA", 2) + word(8) + std::string("\x01\x01\x00\x00\x3F\x00", 6);
  const std::string quantiser = std::string("\xFF\xDB", 2) + word(67) + std::string(65, '\x01');
  return std::string("\xFF\xD8", 2) + quantiser + frame_header + scan_header +
         std::string(scan_bytes, filler) + std::string("\xFF\xD9", 2);
}

}  // namespace rovio_sfm
