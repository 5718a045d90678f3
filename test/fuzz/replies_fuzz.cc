// What the robot answers: reports, and the header lines of its stream.
#include "fuzz/fuzz_input.h"
#include "rovio_sfm/rovio/header_value.h"
#include "rovio_sfm/rovio/mjpeg_parser.h"
#include "rovio_sfm/rovio/rovio_protocol.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  const std::string_view text = FuzzInput(data, size).Rest();
  std::string error;
  ParseReport(text, &error);
  ParseMcuReport(text, &error);
  ParseNavCode(text);
  BoundaryOf(text);
  if (const auto value = HeaderValue(text, "Content-Length")) ParseContentLength(*value);
  return 0;
}
