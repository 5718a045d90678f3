// The stream of a robot: the first byte says in pieces of which size it arrives.
#include "fuzz/fuzz_input.h"
#include "rovio_sfm/rovio/mjpeg_parser.h"
#include "rovio_sfm/util/jpeg_check.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  constexpr size_t kMaxPixels = 256 * 256;
  FuzzInput input(data, size);
  const size_t piece = 1 + size_t{input.Take<uint8_t>()};
  MjpegParserOptions options;
  options.max_part_bytes = 1 << 14;
  MjpegParser parser("WINBONDBOUDARY", options,
                     [](const MjpegPart& part) { CheckJpeg(part.body, kMaxPixels); });
  for (int64_t stamp_ns = 0; !input.IsEmpty(); ++stamp_ns) {
    if (!parser.Feed(input.TakeBytes(piece), stamp_ns)) break;
  }
  return 0;
}
