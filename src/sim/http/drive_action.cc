#include "rovio_sfm/sim/http/drive_action.h"

namespace rovio_sfm::sim {
namespace {

constexpr long kStop = 0;
constexpr long kHeadUp = 11;
constexpr long kHeadDown = 12;
constexpr long kHeadMiddle = 13;
constexpr long kTurnLeftBySteps = 17;
constexpr long kTurnRightBySteps = 18;
constexpr long kMaxAngleSteps = 255;  // the MCU takes one byte

bool IsMotion(long drive) {
  return (drive >= 1 && drive <= 10) || drive == kTurnLeftBySteps || drive == kTurnRightBySteps;
}

HeadPosition HeadTarget(long drive) {
  if (drive == kHeadUp) return HeadPosition::kUp;
  return drive == kHeadDown ? HeadPosition::kDown : HeadPosition::kMiddle;
}

NavResponse Drive(long drive, const Parameters& parameters, ServerContext& context) {
  if (!parameters.Has("speed")) return NavResponse::kParameterMissing;
  const long speed = parameters.GetLong("speed").value_or(0);
  if (speed < 1 || speed > 10) return NavResponse::kOutOfRange;
  DriveCommand command;
  command.drive = static_cast<int>(drive);
  command.speed = static_cast<int>(speed);
  command.hold_ns = context.options.drive_hold_ns;
  if (drive == kTurnLeftBySteps || drive == kTurnRightBySteps) {
    if (parameters.Has("angle")) {
      const long angle = parameters.GetLong("angle").value_or(-1);
      if (angle < 0 || angle > kMaxAngleSteps) return NavResponse::kOutOfRange;
      command.angle_steps = static_cast<int>(angle);
    }
    const bool spins =
        context.quirks.With([](Quirks& quirks) { return quirks.Strikes(Quirk::kSpinForever); });
    if (spins) command.hold_ns = kHoldForever;
  }
  return context.robot.With([&](RobotBackend& robot) { return robot.Drive(command); });
}

}  // namespace

NavResponse RunDriveAction(const Parameters& parameters, ServerContext& context) {
  if (!parameters.Has("drive")) return NavResponse::kParameterMissing;
  const long drive = parameters.GetLong("drive").value_or(-1);
  if (drive == kStop) {
    context.robot.With([](RobotBackend& robot) { robot.Stop(); });
    return NavResponse::kSuccess;
  }
  const bool is_head = drive >= kHeadUp && drive <= kHeadMiddle;
  if (!is_head && !IsMotion(drive)) return NavResponse::kOutOfRange;
  const bool is_busy =
      context.quirks.With([](Quirks& quirks) { return quirks.Value(Quirk::kBusy) > 0.0; });
  if (is_busy) return NavResponse::kBusy;
  if (!is_head) return Drive(drive, parameters, context);
  context.robot.With([&](RobotBackend& robot) { robot.MoveHead(HeadTarget(drive)); });
  return NavResponse::kSuccess;
}

NavResponse RunSwitchAction(const Parameters& parameters, ServerContext& context) {
  if (!parameters.Has("IR") && !parameters.Has("LIGHT")) return NavResponse::kParameterMissing;
  const long infrared = parameters.GetLong("IR").value_or(parameters.Has("IR") ? -1 : 0);
  const long light = parameters.GetLong("LIGHT").value_or(parameters.Has("LIGHT") ? -1 : 0);
  if (infrared < 0 || infrared > 1 || light < 0 || light > 1) return NavResponse::kOutOfRange;
  context.robot.With([&](RobotBackend& robot) {
    if (parameters.Has("IR")) robot.SwitchInfrared(infrared == 1);
    if (parameters.Has("LIGHT")) robot.SwitchHeadlight(light == 1);
  });
  return NavResponse::kSuccess;
}

}  // namespace rovio_sfm::sim
