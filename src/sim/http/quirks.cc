#include "rovio_sfm/sim/http/quirks.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm::sim {

const std::array<QuirkInfo, kNumQuirks>& AllQuirks() {
  constexpr double kHour = 3600.0;
  constexpr double kMaxNth = 1e6;
  static const std::array<QuirkInfo, kNumQuirks> kAll = {{
      {Quirk::kStall, "stall", QuirkKind::kTimed, kHour, "s without new pictures"},
      {Quirk::kSilence, "silence", QuirkKind::kTimed, kHour, "s without any byte"},
      {Quirk::kReboot, "reboot", QuirkKind::kTimed, kHour, "s the robot is away"},
      {Quirk::kTruncateJpeg, "truncate_jpeg", QuirkKind::kEveryNth, kMaxNth,
       "every Nth picture is cut"},
      {Quirk::kShortBody, "short_body", QuirkKind::kEveryNth, kMaxNth,
       "every Nth still ends early"},
      {Quirk::kResetEvery, "reset_every", QuirkKind::kEveryNth, kMaxNth,
       "every Nth request is reset"},
      {Quirk::kResetStream, "reset_stream", QuirkKind::kEveryNth, kMaxNth,
       "a stream is reset after N parts"},
      {Quirk::kRequireLogin, "require_login", QuirkKind::kValue, 1.0, "1: check passwords"},
      {Quirk::kHangBlocksAll, "hang_blocks_all", QuirkKind::kValue, 1.0,
       "1: one request at a time"},
      {Quirk::kSlowNav, "slow_nav", QuirkKind::kValue, kHour, "s before each nav reply"},
      {Quirk::kLostTicks, "lost_ticks", QuirkKind::kValue, 100.0,
       "Hz at which the robot itself clears the counters"},
      {Quirk::kSpinForever, "spin_forever", QuirkKind::kEveryNth, kMaxNth,
       "every Nth stepwise turn never ends"},
      {Quirk::kBusy, "busy", QuirkKind::kValue, 1.0, "1: drive commands get code 2"},
      {Quirk::kCrossReplies, "cross_replies", QuirkKind::kEveryNth, kMaxNth,
       "every Nth nav reply is another's"},
      {Quirk::kShortMcu, "short_mcu", QuirkKind::kEveryNth, kMaxNth, "every Nth MCU report is cut"},
      {Quirk::kBattery, "battery", QuirkKind::kValue, 127.0, "battery reading shown"},
      {Quirk::kWifi, "wifi", QuirkKind::kValue, 254.0, "Wi-Fi signal shown"},
  }};
  return kAll;
}

bool Quirks::Set(std::string_view name, double value, int64_t now_ns, std::string* error) {
  if (name == "none") {
    states_ = {};
    return true;
  }
  const auto& all = AllQuirks();
  const auto info = std::find_if(all.begin(), all.end(),
                                 [name](const QuirkInfo& other) { return other.name == name; });
  if (info == all.end()) {
    *error = "no quirk is called " + std::string(name);
    return false;
  }
  if (!(value >= 0.0 && value <= info->max_value)) {
    *error = "quirk " + std::string(name) + " = " + std::to_string(value) + " is outside 0 … " +
             std::to_string(info->max_value);
    return false;
  }
  State& state = states_[static_cast<size_t>(info->quirk)];
  state = {value, now_ns + static_cast<int64_t>(std::llround(value * 1e9)), 0};
  return true;
}

double Quirks::Value(Quirk quirk) const { return states_[static_cast<size_t>(quirk)].value; }

bool Quirks::IsActive(Quirk quirk, int64_t now_ns) const {
  return now_ns < states_[static_cast<size_t>(quirk)].until_ns;
}

bool Quirks::Strikes(Quirk quirk) {
  State& state = states_[static_cast<size_t>(quirk)];
  const auto interval = static_cast<uint64_t>(state.value);
  if (interval == 0) return false;
  return ++state.num_events % interval == 0;
}

}  // namespace rovio_sfm::sim
