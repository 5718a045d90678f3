#include "rovio_sfm/rovio/settings_keeper.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kPatienceNs = 5000000000;  // the robot takes some seconds to change the size

}  // namespace

bool operator==(const CameraSettings& a, const CameraSettings& b) {
  return a.resolution == b.resolution && a.compression == b.compression &&
         a.frame_rate == b.frame_rate && a.brightness == b.brightness;
}

SettingsKeeper::Step SettingsKeeper::Next(const CameraSettings& present, int64_t now_ns) {
  if (is_done_ || !wanted_) return Step::kNothing;
  if (present == *wanted_) {
    is_done_ = true;
    return Step::kAgreed;
  }
  if (!requested_ns_) return Step::kRequest;
  if (now_ns - *requested_ns_ < kPatienceNs) return Step::kNothing;
  is_done_ = true;
  return Step::kRefused;
}

void SettingsKeeper::MarkRequested(bool has_arrived, int64_t now_ns) {
  if (has_arrived) requested_ns_ = now_ns;
}

std::string Describe(const CameraSettings& settings) {
  return "resolution " + std::to_string(settings.resolution) + ", compression " +
         std::to_string(settings.compression) + ", frame_rate " +
         std::to_string(settings.frame_rate) + ", brightness " +
         std::to_string(settings.brightness);
}

}  // namespace rovio_sfm
