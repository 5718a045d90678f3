#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "rovio_sfm/sim/http/command.h"
#include "rovio_sfm/sim/http/mcu_report.h"
#include "rovio_sfm/sim/http/status_string.h"

namespace rovio_sfm::sim {
namespace {

void GetStatus(const CommandCall& call, CommandReply* reply) {
  reply->fields.Add("Status", FormatStatus(TakeSnapshot(call.context, call.caller.privilege)));
}

void GetVer(const CommandCall&, CommandReply* reply) {
  reply->fields.Add("Version", "Mar 16 2010 13:25:24 $Revision: 5.3705$");
}

void GetMac(const CommandCall&, CommandReply* reply) {
  reply->fields.Add("MAC", "00:01:36:00:00:01");
}

void GetHttp(const CommandCall&, CommandReply* reply) {
  reply->fields.Add("Port0", "80");
  reply->fields.Add("Port1", "0");
}

void GetTime(const CommandCall& call, CommandReply* reply) {
  reply->fields.Add("Sec1970", std::to_string(call.context.robot.now_ns() / 1'000'000'000));
  reply->fields.Add("TimeZone", "0");
  reply->fields.Add("NtpServer", "");
  reply->fields.Add("UseNtp", "0");
}

// Both keep their reply's effect until the connection is over.
void Reboot(const CommandCall&, CommandReply* reply) {
  reply->fields.Add("Return", "OK");
  reply->reboots_robot = true;
}

void SetFactoryDefault(const CommandCall& call, CommandReply* reply) {
  call.context.settings.With([](RobotSettings& settings) { settings = {}; });
  call.context.accounts.With([](Accounts& accounts) { accounts = {}; });
  Reboot(call, reply);
}

// Whether the text is a length byte and that many bytes, in hex, at most 32 in all.
bool IsMcuPacket(const std::string& text) {
  const bool hex =
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
  if (!hex || text.size() < 4 || text.size() > 64 || text.size() % 2 != 0) return false;
  return std::stoul(text.substr(0, 2), nullptr, 16) + 1 == text.size() / 2;
}

// A raw MCU packet: answered with the MCU's report, otherwise without effect (the LEDs).
void RunMcuPacket(const CommandCall& call, CommandReply* reply) {
  if (!IsMcuPacket(call.parameters.Get("parameters"))) {
    reply->fields.Add("error", "parameters");
    return;
  }
  const auto reading = call.context.robot.With([](RobotBackend& robot) { return robot.PeekMcu(); });
  reply->fields.Add("responses", FormatMcuReport(reading));
}

// One byte in hex with or without 0x, or decimal; nothing for anything else.
std::optional<uint8_t> ByteOf(const std::string& text) {
  const bool is_plain = !text.empty() && text.size() <= 4 &&
                        std::all_of(text.begin(), text.end(),
                                    [](unsigned char c) { return std::isxdigit(c) || c == 'x'; });
  if (!is_plain) return std::nullopt;
  char* end = nullptr;
  const unsigned long value = std::strtoul(text.c_str(), &end, 0);
  if (*end != '\0' || value > 0xff) return std::nullopt;
  return static_cast<uint8_t>(value);
}

std::string RegisterText(uint8_t address, uint8_t value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%08x=%08x", address, value);
  return text;
}

// The image sensor's registers (rovio-http.md, section 3); of the other actions nothing is known.
void RunDebug(const CommandCall& call, CommandReply* reply) {
  const std::string action = call.parameters.Get("action");
  const auto address = ByteOf(call.parameters.Get("address"));
  const auto value = ByteOf(call.parameters.Get("value"));
  const bool writes = action == "write_i2c";
  if (action != "read_i2c" && !writes) return reply->fields.Add("error", "action");
  if (!address) return reply->fields.Add("error", "address");
  if (writes && !value) return reply->fields.Add("error", "value");
  call.context.settings.With([&](RobotSettings& settings) {
    uint8_t& cell = settings.sensor_registers[*address];
    if (writes) cell = *value;
    reply->fields.Add(action, RegisterText(*address, cell));
  });
}

}  // namespace

std::vector<Command> SystemCommands() {
  return {{"GetStatus.cgi", NeedsUser, GetStatus},
          {"GetVer.cgi", NeedsUser, GetVer},
          {"GetMac.cgi", NeedsUser, GetMac},
          {"GetHttp.cgi", NeedsUser, GetHttp},
          {"GetTime.cgi", NeedsUser, GetTime},
          {"Reboot.cgi", NeedsAdmin, Reboot},
          {"SetFactoryDefault.cgi", NeedsAdmin, SetFactoryDefault},
          {"debug.cgi", NeedsAdmin, RunDebug},
          {"mcu", NeedsUser, RunMcuPacket}};
}

}  // namespace rovio_sfm::sim
