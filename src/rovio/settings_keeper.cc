#include "rovio_sfm/rovio/settings_keeper.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kPatienceNs = 5000000000;  // the robot takes some seconds to change the size

bool AreAgreedOn(const std::optional<int>& a, const std::optional<int>& b) {
  return !a || !b || *a == *b;
}

bool AreAllKnown(const SomeSettings& settings) {
  return settings.resolution && settings.compression && settings.frame_rate && settings.brightness;
}

// The newer ones, where they are known.
SomeSettings Latest(const SomeSettings& newer, SomeSettings settings) {
  if (newer.resolution) settings.resolution = newer.resolution;
  if (newer.compression) settings.compression = newer.compression;
  if (newer.frame_rate) settings.frame_rate = newer.frame_rate;
  if (newer.brightness) settings.brightness = newer.brightness;
  return settings;
}

std::string TextOf(const std::optional<int>& value) { return value ? std::to_string(*value) : "?"; }

}  // namespace

bool AreAgreed(const SomeSettings& a, const SomeSettings& b) {
  return AreAgreedOn(a.resolution, b.resolution) && AreAgreedOn(a.compression, b.compression) &&
         AreAgreedOn(a.frame_rate, b.frame_rate) && AreAgreedOn(a.brightness, b.brightness);
}

SettingsKeeper::SettingsKeeper(const std::optional<CameraSettings>& wanted) {
  if (wanted) wanted_ = SomeSettings(*wanted);
}

SettingsKeeper::Step SettingsKeeper::Next(const SomeSettings& present, int64_t now_ns) {
  if (!wanted_) return Step::kNothing;
  if (is_done_) {  // by a service, or by another hand; what was refused is wished for again
    if (is_agreed_) wanted_ = Latest(present, *wanted_);
    return Step::kNothing;
  }
  if (AreAgreed(present, *wanted_) && (was_requested_ || AreAllKnown(present))) {
    is_done_ = is_agreed_ = true;
    return Step::kAgreed;
  }
  if (!requested_ns_) return Step::kRequest;
  if (now_ns - *requested_ns_ < kPatienceNs) return Step::kNothing;
  is_done_ = true;
  return Step::kRefused;
}

void SettingsKeeper::MarkRequested(bool has_arrived, int64_t now_ns) {
  if (!has_arrived) return;
  requested_ns_ = now_ns;
  was_requested_ = true;
}

void SettingsKeeper::BeginAgain() {
  requested_ns_.reset();
  is_done_ = is_agreed_ = false;
}

std::string Describe(const SomeSettings& settings) {
  return "resolution " + TextOf(settings.resolution) + ", compression " +
         TextOf(settings.compression) + ", frame_rate " + TextOf(settings.frame_rate) +
         ", brightness " + TextOf(settings.brightness);
}

}  // namespace rovio_sfm
