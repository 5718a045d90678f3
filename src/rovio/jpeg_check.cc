#include "rovio_sfm/rovio/jpeg_check.h"

namespace rovio_sfm {
namespace {

constexpr size_t kSmallestJpeg = 134;  // bytes; what public clients of the robot take as the least
constexpr int kStartOfScan = 0xDA;

int ByteAt(std::string_view bytes, size_t i) { return static_cast<unsigned char>(bytes[i]); }
int WordAt(std::string_view bytes, size_t i) {
  return ByteAt(bytes, i) * 256 + ByteAt(bytes, i + 1);
}

bool EndsWithEndMarker(std::string_view bytes) {
  const size_t last = bytes.find_last_not_of("\r\n");
  return last != std::string_view::npos && last >= 1 && ByteAt(bytes, last) == 0xD9 &&
         ByteAt(bytes, last - 1) == 0xFF;
}

// SOF0, SOF1 and SOF2; lossless and arithmetic kinds are not decoded anywhere here.
bool IsFrameHeader(int marker) { return marker >= 0xC0 && marker <= 0xC2; }

// Fills the size from the segment at `i` (its length field); false when it does not fit.
bool ReadFrameHeader(std::string_view bytes, size_t i, JpegInfo* info) {
  if (WordAt(bytes, i) < 8) return false;
  info->height_px = WordAt(bytes, i + 3);
  info->width_px = WordAt(bytes, i + 5);
  return info->height_px > 0 && info->width_px > 0;
}

// Walks from marker to marker behind SOI; ends at the first scan.
JpegFault WalkSegments(std::string_view bytes, JpegInfo* info) {
  size_t i = 2;
  while (i + 4 <= bytes.size()) {
    if (ByteAt(bytes, i) != 0xFF) return JpegFault::kBadSegment;
    const int marker = ByteAt(bytes, i + 1);
    if (marker == 0xFF) {  // a fill byte
      ++i;
      continue;
    }
    const size_t length = static_cast<size_t>(WordAt(bytes, i + 2));
    if (length < 2 || i + 2 + length > bytes.size()) return JpegFault::kBadSegment;
    if (marker == kStartOfScan) {
      return info->width_px > 0 ? JpegFault::kNone : JpegFault::kNoFrameHeader;
    }
    if (IsFrameHeader(marker) && !ReadFrameHeader(bytes, i + 2, info)) {
      return JpegFault::kBadSegment;
    }
    i += 2 + length;
  }
  return JpegFault::kBadSegment;
}

}  // namespace

const char* NameOf(JpegFault fault) {
  switch (fault) {
    case JpegFault::kNone:
      return "none";
    case JpegFault::kTooShort:
      return "too short";
    case JpegFault::kNoStart:
      return "no start marker";
    case JpegFault::kNoEnd:
      return "truncated: no end marker";
    case JpegFault::kBadSegment:
      return "bad segment";
    case JpegFault::kNoFrameHeader:
      return "no frame header";
    case JpegFault::kTooManyPixels:
      return "too many pixels";
  }
  return "unknown";
}

JpegInfo CheckJpeg(std::string_view bytes, size_t max_pixels) {
  JpegInfo info;
  if (bytes.size() < kSmallestJpeg) return info;
  if (WordAt(bytes, 0) != 0xFFD8) {
    info.fault = JpegFault::kNoStart;
    return info;
  }
  info.fault = WalkSegments(bytes, &info);
  const size_t num_pixels =
      static_cast<size_t>(info.width_px) * static_cast<size_t>(info.height_px);
  if (num_pixels > max_pixels) info.fault = JpegFault::kTooManyPixels;
  if (info.fault == JpegFault::kNone && !EndsWithEndMarker(bytes)) info.fault = JpegFault::kNoEnd;
  return info;
}

}  // namespace rovio_sfm
