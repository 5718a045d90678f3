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

std::string TextOf(const std::optional<int>& value) { return value ? std::to_string(*value) : "?"; }

}  // namespace

bool AreAgreed(const SomeSettings& a, const SomeSettings& b) {
  return AreAgreedOn(a.resolution, b.resolution) && AreAgreedOn(a.compression, b.compression) &&
         AreAgreedOn(a.frame_rate, b.frame_rate) && AreAgreedOn(a.brightness, b.brightness);
}

SettingsKeeper::Step SettingsKeeper::Next(const SomeSettings& present, int64_t now_ns) {
  if (is_done_ || !wanted_) return Step::kNothing;
  if (AreAgreed(present, SomeSettings(*wanted_)) && (requested_ns_ || AreAllKnown(present))) {
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

std::string Describe(const SomeSettings& settings) {
  return "resolution " + TextOf(settings.resolution) + ", compression " +
         TextOf(settings.compression) + ", frame_rate " + TextOf(settings.frame_rate) +
         ", brightness " + TextOf(settings.brightness);
}

}  // namespace rovio_sfm
