#include "rovio_sfm/util/jpeg_check.h"

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it before
#include <vector>

namespace rovio_sfm {
namespace {

constexpr size_t kSmallestJpeg = 4;  // bytes: start and end
constexpr int kEndOfImage = 0xD9, kStartOfScan = 0xDA;
constexpr int kMaxStrayBytes = 16;  // before a marker

int ByteAt(std::string_view bytes, size_t i) { return static_cast<unsigned char>(bytes[i]); }
int WordAt(std::string_view bytes, size_t i) {
  return ByteAt(bytes, i) * 256 + ByteAt(bytes, i + 1);
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

// Where the marker behind a scan begins whose data begin at `i`: entropy-coded bytes never hold FF
// but with a stuffed zero or as a restart marker.
size_t SkipScan(std::string_view bytes, size_t i) {
  for (; i + 1 < bytes.size(); ++i) {
    if (ByteAt(bytes, i) != 0xFF) continue;
    const int next = ByteAt(bytes, i + 1);
    const bool is_data = next == 0 || next == 0xFF || (next >= 0xD0 && next <= 0xD7);
    if (!is_data) return i;
  }
  return bytes.size();
}

// Walks from marker to marker behind SOI to the end of the image.
JpegFault WalkSegments(std::string_view bytes, JpegInfo* info) {
  size_t i = 2;
  bool has_scan = false;
  while (i + 2 <= bytes.size()) {
    if (ByteAt(bytes, i) != 0xFF) return JpegFault::kBadSegment;
    const int marker = ByteAt(bytes, i + 1);
    if (marker == 0xFF) {  // a fill byte
      ++i;
      continue;
    }
    if (marker == kEndOfImage) {
      info->num_bytes = i + 2;
      return has_scan ? JpegFault::kNone : JpegFault::kNoFrameHeader;
    }
    if (i + 4 > bytes.size()) break;
    const size_t length = static_cast<size_t>(WordAt(bytes, i + 2));
    if (length < 2 || i + 2 + length > bytes.size()) break;
    if (IsFrameHeader(marker) && !ReadFrameHeader(bytes, i + 2, info)) {
      return JpegFault::kBadSegment;
    }
    i += 2 + length;
    if (marker != kStartOfScan) continue;
    if (info->width_px == 0) return JpegFault::kNoFrameHeader;
    has_scan = true;
    i = SkipScan(bytes, i);
  }
  return has_scan ? JpegFault::kNoEnd : JpegFault::kBadSegment;
}

// libjpeg's errors end the decoding by a jump (it is C), its warnings are counted.
struct ErrorManager {
  jpeg_error_mgr base;  // first: libjpeg knows no more of it
  std::jmp_buf on_error;
  int num_warnings = 0;
};

ErrorManager* ManagerOf(j_common_ptr codec) { return reinterpret_cast<ErrorManager*>(codec->err); }

[[noreturn]] void JumpOut(j_common_ptr codec) { std::longjmp(ManagerOf(codec)->on_error, 1); }

void CountWarning(j_common_ptr codec, int level) {
  if (level >= 0) return;  // a trace
  const jpeg_error_mgr& error = *codec->err;
  const bool is_harmless =
      error.msg_code == JWRN_ADOBE_XFORM || error.msg_code == JWRN_JFIF_MAJOR ||
      (error.msg_code == JWRN_EXTRANEOUS_DATA && error.msg_parm.i[0] <= kMaxStrayBytes);
  if (!is_harmless) ++ManagerOf(codec)->num_warnings;
}

// Reads all rows at the smallest scale: the whole of the data is looked at, few pixels are made.
// No object with a destructor may live here: libjpeg's errors jump over it.
void ReadRows(jpeg_decompress_struct* codec, std::string_view bytes, std::vector<JSAMPLE>* row) {
  jpeg_mem_src(codec, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(codec, TRUE);
  codec->scale_num = 1;
  codec->scale_denom = 8;
  codec->out_color_space = codec->jpeg_color_space;
  jpeg_start_decompress(codec);
  row->resize(static_cast<size_t>(codec->output_width) *
              static_cast<size_t>(codec->output_components));
  JSAMPROW rows[1] = {row->data()};
  while (codec->output_scanline < codec->output_height) jpeg_read_scanlines(codec, rows, 1);
  jpeg_finish_decompress(codec);
}

bool AreScansWhole(std::string_view bytes) {
  jpeg_decompress_struct codec;
  ErrorManager errors;
  std::vector<JSAMPLE> row;
  codec.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = JumpOut;
  errors.base.emit_message = CountWarning;
  if (setjmp(errors.on_error) != 0) {
    jpeg_destroy_decompress(&codec);
    return false;
  }
  jpeg_create_decompress(&codec);
  ReadRows(&codec, bytes, &row);
  jpeg_destroy_decompress(&codec);
  return errors.num_warnings == 0;
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
    case JpegFault::kDamagedScan:
      return "damaged: image data are missing or wrong";
  }
  return "unknown";
}

JpegInfo CheckJpegMarkers(std::string_view bytes, size_t max_pixels) {
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
  return info;
}

JpegInfo CheckJpeg(std::string_view bytes, size_t max_pixels) {
  JpegInfo info = CheckJpegMarkers(bytes, max_pixels);
  if (info.fault == JpegFault::kNone && !AreScansWhole(bytes.substr(0, info.num_bytes))) {
    info.fault = JpegFault::kDamagedScan;
  }
  return info;
}

}  // namespace rovio_sfm
