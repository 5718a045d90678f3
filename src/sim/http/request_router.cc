#include "rovio_sfm/sim/http/request_router.h"

#include <algorithm>
#include <vector>

#include "rovio_sfm/sim/http/command.h"
#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm::sim {
namespace {

struct PendingCommand {
  std::string name;
  const Command* command = nullptr;
  Parameters parameters;
};

// The commands of a request. An unknown Cmd stays in the list (it asks for a user) and does
// nothing.
std::vector<PendingCommand> ListCommands(const HttpRequest& request, bool is_bundle) {
  if (!is_bundle) {
    const std::string name = request.path.substr(1);
    return {{name, FindCommand(name), Parameters::Parse(request.query)}};
  }
  std::vector<PendingCommand> commands;
  for (const std::string& piece : SplitCommands(request.query)) {
    const Parameters parameters = Parameters::Parse(piece);
    const std::string name = parameters.Get("Cmd");
    commands.push_back({name, FindCommand(name), parameters});
  }
  return commands;
}

Privilege RequiredLevel(const std::vector<PendingCommand>& commands, const Caller& caller,
                        ServerContext& context) {
  Privilege required = Privilege::kUser;
  for (const PendingCommand& pending : commands) {
    if (pending.command == nullptr) continue;
    required = std::max(required, pending.command->level({pending.parameters, caller, context}));
  }
  return required;
}

// Header lines cannot be smuggled in through the address.
HttpResponse Redirect(std::string url) {
  url.erase(std::remove_if(url.begin(), url.end(), [](unsigned char c) { return c < 0x20; }),
            url.end());
  HttpResponse response;
  response.status = 302;
  response.extra_headers = "Location: " + url + "\r\n";
  response.content_type = "text/html";
  return response;
}

RoutedReply RunCommands(const std::vector<PendingCommand>& commands, bool is_bundle,
                        const HttpRequest& request, const Caller& caller, ServerContext& context) {
  RoutedReply routed;
  std::string text;
  for (const PendingCommand& pending : commands) {
    if (pending.command == nullptr) continue;
    CommandReply reply;
    pending.command->run({pending.parameters, caller, context}, &reply);
    if (is_bundle) text += "Cmd = " + pending.name + "\n";
    text += reply.fields.ToText();
    if (reply.reboots_robot) routed.away = std::chrono::nanoseconds(context.options.reboot_ns);
  }
  const Parameters options = Parameters::Parse(request.query);
  const std::string url = options.Get("RedirectUrl");
  if (!url.empty()) {
    routed.response = Redirect(url);
    return routed;
  }
  const RenderedReply rendered = RenderReply(text, options);
  routed.response.content_type = rendered.content_type;
  routed.response.body = rendered.body;
  return routed;
}

// What a browser sees first; the robot's own pages are far richer.
HttpResponse StartPage() {
  HttpResponse response;
  response.content_type = "text/html";
  response.body =
      "<HTML><HEAD><TITLE>Rovio</TITLE></HEAD>\n<BODY><H1>Rovio (simulated)</H1>\n"
      "<IMG SRC=\"/GetData.cgi\" ALT=\"what the camera sees\">\n"
      "<P><A HREF=\"/rev.cgi?Cmd=nav&amp;action=1\">report</A>\n"
      "<A HREF=\"/Jpeg/CamImg0.jpg\">picture</A>\n"
      "<A HREF=\"/GetVer.cgi\">version</A></P>\n</BODY></HTML>\n";
  return response;
}

bool IsStartPath(const std::string& path) { return path == "/" || path == "/index.html"; }

}  // namespace

bool IsStillPath(const std::string& path) {
  constexpr std::string_view kStart = "/Jpeg/CamImg", kEnd = ".jpg";
  return path.size() >= kStart.size() + kEnd.size() && StartsWith(path, kStart) &&
         EndsWith(path, kEnd);
}

bool IsStreamPath(const std::string& path) { return path == "/GetData.cgi"; }

std::optional<HttpResponse> RefuseBelow(Privilege required, const Caller& caller) {
  if (caller.privilege >= required) return std::nullopt;
  return LoginRequired(required == Privilege::kAdmin ? "Administrator for Rovio" : "Rovio");
}

RoutedReply AnswerRequest(const HttpRequest& request, const Caller& caller,
                          ServerContext& context) {
  if (IsStartPath(request.path) && request.method == "GET") {
    if (auto refusal = RefuseBelow(Privilege::kUser, caller)) return {*refusal, std::nullopt};
    return {StartPage(), std::nullopt};
  }
  const bool is_bundle = request.path == "/rev.cgi" || request.path == "/Cmd.cgi";
  const bool is_command = is_bundle || FindCommand(request.path.substr(1)) != nullptr;
  if (!is_command || (request.method != "GET" && request.method != "POST")) {
    return {ErrorPage(404), std::nullopt};
  }
  const auto commands = ListCommands(request, is_bundle);
  if (auto refusal = RefuseBelow(RequiredLevel(commands, caller, context), caller)) {
    return {*refusal, std::nullopt};
  }
  return RunCommands(commands, is_bundle, request, caller, context);
}

}  // namespace rovio_sfm::sim
