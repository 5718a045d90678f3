#pragma once

#include <cstddef>
#include <string_view>

namespace rovio_sfm {

// Why an image is refused; kNone when it may be decoded.
enum class JpegFault {
  kNone,
  kTooShort,       // cannot be an image at all
  kNoStart,        // no SOI marker at the first byte
  kNoEnd,          // no EOI marker at the last bytes: truncated
  kBadSegment,     // a segment runs past the end, or a marker is missing where one must be
  kNoFrameHeader,  // no SOF of a kind that is decoded (baseline, extended, progressive)
  kTooManyPixels
};

// What the markers of a JPEG say. Sizes are 0 where no frame header was reached.
struct JpegInfo {
  JpegFault fault = JpegFault::kTooShort;
  int width_px = 0;
  int height_px = 0;
};

const char* NameOf(JpegFault fault);

// Walks the markers up to the first scan and looks for the end marker, without decoding a pixel.
// Line ends after the end marker are allowed: the robot puts them before a boundary.
JpegInfo CheckJpeg(std::string_view bytes, size_t max_pixels);

}  // namespace rovio_sfm
