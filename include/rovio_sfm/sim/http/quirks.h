#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rovio_sfm::sim {

// The faults of real robots, each a switch (rovio-http.md, section 6). All are off at first.
enum class Quirk {
  kStall,          // s: no new picture comes; stills hang, the stream sends idle CRLFs
  kSilence,        // s: no byte leaves the robot, connections stay open
  kReboot,         // s: connections drop, clients are refused, then the robot is back
  kTruncateJpeg,   // every Nth picture ends half-way
  kShortBody,      // every Nth still ends before its announced length
  kResetEvery,     // every Nth request is answered by a reset of its connection
  kResetStream,    // every Nth part of a stream is followed by a reset
  kRequireLogin,   // 1: passwords are checked (the same switch as SetUserCheck.cgi)
  kHangBlocksAll,  // 1: one request at a time, so that a hanging still holds up everybody
  kSlowNav,        // s before each nav reply
  kLostTicks,      // Hz at which the robot's own software reads, and so clears, the wheel counters
  kSpinForever,    // every Nth stepwise turn never ends by itself
  kBusy,           // 1: drive commands get code 2, as while the robot drives home on low battery
  kCrossReplies,   // every Nth nav reply is the answer to another question
  kShortMcu,       // every Nth MCU report is cut short
  kBattery,        // the battery reading shown instead of the true one; 0: the true one
  kWifi,           // the Wi-Fi signal shown, 0 … 254; 0: the usual one
};
inline constexpr size_t kNumQuirks = static_cast<size_t>(Quirk::kWifi) + 1;

enum class QuirkKind { kValue, kEveryNth, kTimed };

struct QuirkInfo {
  Quirk quirk;
  std::string_view name;  // on the command line and in /sim?quirk=NAME
  QuirkKind kind;
  double max_value;  // the least is 0 = off
  std::string_view help;
};

const std::array<QuirkInfo, kNumQuirks>& AllQuirks();

// The state of all switches. Not thread-safe.
class Quirks {
 public:
  // A timed quirk lasts value seconds from now; "none" switches all off. False, with the reason,
  // for unknown names and values out of range.
  bool Set(std::string_view name, double value, int64_t now_ns, std::string* error);

  double Value(Quirk quirk) const;
  bool IsActive(Quirk quirk, int64_t now_ns) const;  // of a timed quirk

  // Counts one more event of an every-Nth quirk; true when it strikes.
  bool Strikes(Quirk quirk);

 private:
  struct State {
    double value = 0.0;
    int64_t until_ns = 0;
    uint64_t num_events = 0;
  };

  std::array<State, kNumQuirks> states_{};
};

}  // namespace rovio_sfm::sim
