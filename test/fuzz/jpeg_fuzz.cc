// A JPEG from anywhere, and what it would be announced as.
#include "fuzz/fuzz_input.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/jpeg_check.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  constexpr size_t kMaxPixels = 512 * 512;
  const std::string_view bytes = FuzzInput(data, size).Rest();
  const JpegInfo info = CheckJpeg(bytes, kMaxPixels);
  if (info.fault == JpegFault::kNone) {
    ROVIO_CHECK(info.width_px > 0 && info.height_px > 0 && info.num_bytes <= bytes.size());
    ROVIO_CHECK(CheckJpegMarkers(bytes, kMaxPixels).fault == JpegFault::kNone);
  }
  return 0;
}
