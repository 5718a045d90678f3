// Calibrations, as text and as camera_info YAML, and the points that they make.
#include <stdexcept>

#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_input.h"
#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/io/calibration.h"

namespace {

template <typename Read>
void Try(const Read& read) {
  try {
    const rovio_sfm::Camera camera = read();
    for (const double share : {0.0, 0.5, 1.0}) {
      rovio_sfm::NormalizedFromPixel(camera, {share * camera.width, share * camera.height});
    }
    rovio_sfm::CameraInfoYaml(camera, "fuzz");
  } catch (const std::runtime_error&) {  // refused, and says why
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  const FuzzFile file(FuzzInput(data, size).Rest());
  Try([&] { return ReadCalibrationText(file.Path()); });
  Try([&] { return ReadCameraInfo(file.Path()); });
  return 0;
}
