#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rovio_sfm {

struct ImageSize {
  int width = 0, height = 0;  // px
};

struct DecodeResult {
  cv::Mat bgr;         // 8-bit BGR; empty on failure
  std::string reason;  // why not, in one sentence; empty on success
};

// The size that a JPEG's frame header or a PNG's IHDR announces, without decoding; nothing if the
// bytes are neither or the header is broken.
std::optional<ImageSize> EncodedImageSize(const std::vector<uint8_t>& encoded);

// Decodes untrusted JPEG or PNG bytes; the pixel count is checked first, and a JPEG that lost some
// of its data is refused (util/jpeg_check.h): it would decode half grey. EXIF orientation is
// ignored: the calibration belongs to the sensor's rows and columns. Of 16 bits a channel the eight
// topmost that are in use remain.
DecodeResult DecodeImage(const std::vector<uint8_t>& encoded, int64_t max_pixels);

}  // namespace rovio_sfm
