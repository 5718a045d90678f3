#include "rovio_sfm/rovio/rovio_client.h"

#include <utility>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxReplyBytes = 16 * 1024;

// The reply, parsed, or the fault.
template <typename T, typename Parse>
RobotReply<T> ParseReply(RobotOutcome outcome, const std::string& body, const Parse& parse) {
  if (!outcome.IsOk()) return {std::move(outcome), std::nullopt};
  std::string error;
  std::optional<T> value = parse(body, &error);
  if (value) return {{}, std::move(value)};
  return {{RobotFault::kMalformed, error}, std::nullopt};
}

}  // namespace

RobotOutcome RovioClient::Fetch(const std::string& target, size_t max_bytes,
                                HttpResponse* response) {
  *response = transport_->Get(target, max_bytes);
  if (response->fault != HttpFault::kNone) {
    return {RobotFault::kLink, std::string(NameOf(response->fault)) + ": " + response->message};
  }
  if (response->status == 401) return {RobotFault::kDenied, "login refused (401)"};
  if (response->status != 200) {
    return {RobotFault::kStatus, "HTTP status " + std::to_string(response->status)};
  }
  return {};
}

RobotOutcome RovioClient::SendNav(const std::string& target) {
  HttpResponse response;
  RobotOutcome outcome = Fetch(target, kMaxReplyBytes, &response);
  if (!outcome.IsOk()) return outcome;
  const std::optional<int> code = ParseNavCode(response.body);
  if (!code) return {RobotFault::kMalformed, "no reply to Cmd=nav"};
  if (*code != 0) return {RobotFault::kRefused, DescribeNavCode(*code)};
  return {};
}

RobotOutcome RovioClient::Drive(const DriveCommand& command) {
  if (command.code != DriveCode::kStop) {
    return SendNav(DriveTarget(command.code, command.speed));
  }
  const RobotOutcome first = SendNav(StopMotionTarget());
  const RobotOutcome second = SendNav(DriveTarget(DriveCode::kStop, 0));
  return second.IsOk() ? second : first;
}

RobotOutcome RovioClient::MoveHead(HeadPosition position) { return SendNav(HeadTarget(position)); }
RobotOutcome RovioClient::SetHeadlight(bool on) { return SendNav(HeadlightTarget(on)); }
RobotOutcome RovioClient::SetInfrared(bool on) { return SendNav(InfraredTarget(on)); }
RobotOutcome RovioClient::Dock() { return SendNav(DockTarget()); }
RobotOutcome RovioClient::EndAutonomy() { return SendNav(ResetStateTarget()); }

RobotReply<RobotReport> RovioClient::GetReport() {
  HttpResponse response;
  RobotOutcome outcome = Fetch(ReportTarget(), kMaxReplyBytes, &response);
  return ParseReply<RobotReport>(std::move(outcome), response.body, ParseReport);
}

RobotReply<McuReport> RovioClient::GetMcuReport() {
  HttpResponse response;
  RobotOutcome outcome = Fetch(McuReportTarget(), kMaxReplyBytes, &response);
  return ParseReply<McuReport>(std::move(outcome), response.body, ParseMcuReport);
}

RobotReply<StillImage> RovioClient::GetStill(size_t max_bytes) {
  HttpResponse response;
  RobotOutcome outcome = Fetch(StillTarget(num_stills_++), max_bytes, &response);
  if (!outcome.IsOk()) return {std::move(outcome), std::nullopt};
  return {{}, StillImage{std::move(response.body), response.body_duration_s}};
}

RobotOutcome RovioClient::RequestSettings(const SomeSettings& wanted, const SomeSettings& present) {
  RobotOutcome outcome;
  const auto request = [&](const std::optional<int>& wish, const std::optional<int>& now,
                           std::string (*target)(int)) {
    HttpResponse response;
    if (!outcome.IsOk() || !wish || wish == now) return;
    outcome = Fetch(target(*wish), kMaxReplyBytes, &response);
  };
  request(wanted.frame_rate, present.frame_rate, FrameRateTarget);
  request(wanted.brightness, present.brightness, BrightnessTarget);
  request(wanted.compression, present.compression, CompressionTarget);
  request(wanted.resolution, present.resolution, ResolutionTarget);
  return outcome;
}

}  // namespace rovio_sfm
