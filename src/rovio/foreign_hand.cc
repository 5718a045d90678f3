#include "rovio_sfm/rovio/foreign_hand.h"

#include "rovio_sfm/rovio/settings_keeper.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kRollOutNs = 3'000'000'000;    // so long after the last command wheels may turn
constexpr int64_t kSettlingNs = 10'000'000'000;  // the robot takes some seconds to change settings
constexpr int64_t kRememberedNs = 60'000'000'000;
constexpr int kMinTicks = 3;  // in one reading; fewer may be a jolt

int TicksOf(const McuReport& mcu) {
  int sum = 0;
  for (const WheelTicks& wheel : mcu.wheels) sum += wheel.ticks;
  return sum;
}

}  // namespace

void ForeignHand::Look(const McuReport& mcu, int64_t now_ns) {
  const bool is_foreign =
      has_reading_ && TicksOf(mcu) >= kMinTicks && now_ns - own_motion_ns_ > kRollOutNs;
  has_reading_ = true;
  if (is_foreign) Tell("its wheels turn though this driver does not drive", now_ns);
}

void ForeignHand::Look(const RobotReport& report, int64_t now_ns) {
  if (report.state && *report.state != 0) NoteOwnMotion(now_ns);  // it drives by itself
  const bool is_foreign =
      settings_ && !AreAgreed(*settings_, report.camera) && now_ns - own_settings_ns_ > kSettlingNs;
  settings_ = report.camera;
  if (is_foreign) Tell("its camera was changed to " + Describe(report.camera), now_ns);
}

void ForeignHand::Tell(const std::string& reason, int64_t now_ns) {
  reason_ = reason;
  seen_ns_ = now_ns;
}

std::string ForeignHand::Reason(int64_t now_ns) const {
  if (now_ns - seen_ns_ > kRememberedNs) return "";
  return "another driver or client uses this robot: " + reason_;
}

}  // namespace rovio_sfm
