#include "rovio_sfm/sim/http/sim_endpoint.h"

#include <cstdio>

namespace rovio_sfm::sim {
namespace {

std::string FormatPose(const Rigid3& pose) {
  char text[256];
  std::snprintf(text, sizeof(text), "%.9g %.9g %.9g %.9g %.9g %.9g %.9g", pose.translation.x(),
                pose.translation.y(), pose.translation.z(), pose.rotation.x(), pose.rotation.y(),
                pose.rotation.z(), pose.rotation.w());
  return text;
}

std::string FormatTruth(const TruePose& truth) {
  return "time_ns = " + std::to_string(truth.time_ns) +
         "\nworld_from_base = " + FormatPose(truth.world_from_base) +
         "\nworld_from_camera = " + FormatPose(truth.world_from_camera) + "\n";
}

std::string FormatNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

std::string ListQuirks(ServerContext& context) {
  return context.quirks.With([](Quirks& quirks) {
    std::string text;
    for (const QuirkInfo& info : AllQuirks()) {
      text += std::string(info.name) + " = " + FormatNumber(quirks.Value(info.quirk)) + "\n";
    }
    return text;
  });
}

RoutedReply RefuseRequest(const std::string& reason) {
  RoutedReply routed;
  routed.response = ErrorPage(400);
  routed.response.content_type = "text/plain";
  routed.response.body = reason + "\n";
  return routed;
}

RoutedReply SwitchQuirk(const Parameters& parameters, ServerContext& context) {
  const std::string name = parameters.Get("quirk");
  const auto value = ParseDouble(parameters.Has("value") ? parameters.Get("value") : "1");
  if (!value) return RefuseRequest("value is not a number");
  std::string error;
  RoutedReply routed;
  routed.away = ApplyQuirk(name, *value, context, &error);
  if (!error.empty()) return RefuseRequest(error);
  routed.response.body = name + " = " + FormatNumber(*value) + "\n";
  return routed;
}

}  // namespace

std::optional<std::chrono::nanoseconds> ApplyQuirk(const std::string& name, double value,
                                                   ServerContext& context, std::string* error) {
  const int64_t now = context.robot.now_ns();
  const bool accepted =
      context.quirks.With([&](Quirks& quirks) { return quirks.Set(name, value, now, error); });
  if (!accepted) return std::nullopt;
  if (name == "require_login" || name == "none") {
    const bool check = name != "none" && value > 0.0;
    context.accounts.With([&](Accounts& accounts) { accounts.set_checking(check); });
  }
  if (name != "reboot" || value <= 0.0) return std::nullopt;
  return std::chrono::nanoseconds(static_cast<int64_t>(value * 1e9));
}

RoutedReply AnswerSimRequest(const HttpRequest& request, ServerContext& context) {
  const Parameters parameters = Parameters::Parse(request.query);
  if (parameters.Has("quirk")) return SwitchQuirk(parameters, context);
  RoutedReply routed;
  if (parameters.Has("truth")) {
    const auto truth = context.robot.With([](RobotBackend& robot) { return robot.ReadTruth(); });
    routed.response.body = FormatTruth(truth);
  } else if (parameters.Has("quirks")) {
    routed.response.body = ListQuirks(context);
  } else {
    return RefuseRequest("use quirk=NAME&value=V, quirks or truth");
  }
  return routed;
}

}  // namespace rovio_sfm::sim
