#include <algorithm>
#include <functional>
#include <map>

#include "rovio_sfm/sim/http/command.h"
#include "rovio_sfm/sim/http/drive_action.h"
#include "rovio_sfm/sim/http/mcu_report.h"
#include "rovio_sfm/sim/http/nav_library_actions.h"
#include "rovio_sfm/sim/http/nav_report.h"

namespace rovio_sfm::sim {
namespace {

std::string Code(NavResponse response) { return std::to_string(static_cast<int>(response)); }

std::string GetReport(const CommandCall& call) {
  return FormatNavReport(TakeSnapshot(call.context, call.caller.privilege));
}

std::string GetMcuReport(const CommandCall& call) {
  McuReading reading = call.context.robot.With([](RobotBackend& robot) { return robot.ReadMcu(); });
  bool is_short = false;
  call.context.quirks.With([&](Quirks& quirks) {
    const int battery = static_cast<int>(quirks.Value(Quirk::kBattery));
    if (battery > 0) reading.battery = static_cast<uint8_t>(battery);
    is_short = quirks.Strikes(Quirk::kShortMcu);
  });
  const std::string report = FormatMcuReport(reading);
  return is_short ? report.substr(0, report.size() / 2) : report;
}

std::string GetNavState(const CommandCall& call) {
  const auto nav = call.context.robot.With([](RobotBackend& robot) { return robot.ReadNav(); });
  return "0 | state=" + std::to_string(nav.state);
}

std::string StopMotion(const CommandCall& call) {
  call.context.robot.With([](RobotBackend& robot) { robot.Stop(); });
  return Code(NavResponse::kSuccess);
}

std::string ResetNav(const CommandCall& call) {
  call.context.robot.With([](RobotBackend& robot) { robot.AbortAutonomy(); });
  return Code(NavResponse::kSuccess);
}

template <typename Function>
std::string AskRobot(const CommandCall& call, Function function) {
  return Code(call.context.robot.With(function));
}

const std::map<long, std::function<std::string(const CommandCall&)>>& Actions() {
  static const std::map<long, std::function<std::string(const CommandCall&)>> kActions = {
      {1, GetReport},
      {12, [](auto& call) { return AskRobot(call, [](auto& r) { return r.GoHome(false); }); }},
      {13, [](auto& call) { return AskRobot(call, [](auto& r) { return r.GoHome(true); }); }},
      {14, [](auto& call) { return AskRobot(call, [](auto& r) { return r.SaveHome(); }); }},
      {17, ResetNav},
      {18, [](auto& call) { return Code(RunDriveAction(call.parameters, call.context)); }},
      {19, [](auto& call) { return Code(RunSwitchAction(call.parameters, call.context)); }},
      {20, GetMcuReport},
      {22, GetNavState},
      {27, [](auto& call) { return AskRobot(call, [](auto& r) { return r.ClearHome(); }); }},
      {33, StopMotion}};
  return kActions;
}

std::string RunAction(const CommandCall& call) {
  const auto number = call.parameters.GetLong("action");
  const auto action = number ? Actions().find(*number) : Actions().end();
  if (action != Actions().end()) return action->second(call);
  return RunNavLibraryAction(number.value_or(-1), call.parameters, call.context.nav_memory);
}

void RunNav(const CommandCall& call, CommandReply* reply) {
  if (!call.parameters.Has("action")) {
    reply->fields.Add("error", "action parameter is required");
    return;
  }
  double delay_s = 0.0;
  bool is_crossed = false;
  call.context.quirks.With([&](Quirks& quirks) {
    delay_s = quirks.Value(Quirk::kSlowNav);
    is_crossed = quirks.Strikes(Quirk::kCrossReplies);
  });
  if (delay_s > 0.0) {
    call.context.stop.WaitFor(std::chrono::nanoseconds(static_cast<int64_t>(delay_s * 1e9)));
  }
  const std::string answer = RunAction(call);
  reply->fields.Add("responses", is_crossed ? std::string(kNavLibraryVersion) : answer);
}

}  // namespace

Command NavCommand() { return {"nav", NeedsUser, RunNav}; }

}  // namespace rovio_sfm::sim
