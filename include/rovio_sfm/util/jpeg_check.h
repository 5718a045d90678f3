#pragma once

#include <cstddef>
#include <string_view>

namespace rovio_sfm {

// Why an image is refused; kNone when it may be decoded.
enum class JpegFault {
  kNone,
  kTooShort,       // cannot be an image at all
  kNoStart,        // no SOI marker at the first byte
  kNoEnd,          // no EOI marker behind the scans: truncated
  kBadSegment,     // a segment runs past the end, or a marker is missing where one must be
  kNoFrameHeader,  // no SOF of a kind that is decoded (baseline, extended, progressive)
  kTooManyPixels,
  kDamagedScan  // markers are whole, but what lies between them is not: it would decode half grey
};

// What a JPEG says of itself. Sizes are 0 where no frame header was reached.
struct JpegInfo {
  JpegFault fault = JpegFault::kTooShort;
  int width_px = 0;
  int height_px = 0;
  size_t num_bytes = 0;  // up to and with the end marker; what follows is no part of the image
};

const char* NameOf(JpegFault fault);

// Walks all markers, without decoding a pixel.
JpegInfo CheckJpegMarkers(std::string_view bytes, size_t max_pixels);

// The same, and then decodes the scans: what libjpeg warns of (data that end early, codes that do
// not exist) is kDamagedScan; a few stray bytes before a marker, as cheap cameras write, are not.
// The one check of a JPEG from outside: nothing else decodes one that it refuses.
JpegInfo CheckJpeg(std::string_view bytes, size_t max_pixels);

}  // namespace rovio_sfm
