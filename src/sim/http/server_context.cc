#include "rovio_sfm/sim/http/server_context.h"

#include <utility>

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

void ShowQuirks(ServerContext& context, RobotSnapshot* snapshot) {
  context.quirks.With([&](Quirks& quirks) {
    const int battery = static_cast<int>(quirks.Value(Quirk::kBattery));
    const int wifi = static_cast<int>(quirks.Value(Quirk::kWifi));
    if (battery > 0) snapshot->mcu.battery = static_cast<uint8_t>(battery);
    if (wifi > 0) snapshot->wifi_signal_strength = wifi;
  });
}

}  // namespace

bool HttpFaceOptions::IsValid(std::string* error) const {
  constexpr int64_t kHour_ns = 3'600'000'000'000;
  OptionChecker check("face", error);
  check.Range<int64_t>("drive_hold_ns", drive_hold_ns, 1, kHour_ns);
  check.Range<int64_t>("reboot_ns", reboot_ns, 0, kHour_ns);
  check.Range<int64_t>("stream_idle_ns", stream_idle_ns, 1, kHour_ns);
  check.Range("request_timeout_ms", request_timeout_ms, 1, 3'600'000);
  check.Range("idle_timeout_ms", idle_timeout_ms, 1, 3'600'000);
  return check.Passed();
}

ServerContext::ServerContext(const HttpFaceOptions& face_options, RobotBackend& backend,
                             Clock now_ns)
    : options(face_options), robot(backend, std::move(now_ns), quirks) {}

RobotSnapshot TakeSnapshot(ServerContext& context, Privilege caller_privilege) {
  RobotSnapshot snapshot;
  context.robot.With([&](RobotBackend& robot) {
    snapshot.nav = robot.ReadNav();
    snapshot.mcu = robot.PeekMcu();
  });
  snapshot.settings = context.settings.Copy();
  snapshot.caller_privilege = caller_privilege;
  snapshot.is_checking_users =
      context.accounts.With([](Accounts& accounts) { return accounts.is_checking(); });
  if (const auto picture = context.frames.Latest()) {
    constexpr uint64_t kIndexWrap = 800000;
    snapshot.picture_index = static_cast<unsigned>((picture->number - 1) % kIndexWrap);
    snapshot.picture_bytes = static_cast<unsigned>(picture->jpeg->size());
  }
  ShowQuirks(context, &snapshot);
  return snapshot;
}

}  // namespace rovio_sfm::sim
