#pragma once

#include <chrono>
#include <optional>

#include "rovio_sfm/sim/http/accounts.h"
#include "rovio_sfm/sim/http/http_request.h"
#include "rovio_sfm/sim/http/http_response.h"
#include "rovio_sfm/sim/http/server_context.h"

namespace rovio_sfm::sim {

struct RoutedReply {
  HttpResponse response;
  std::optional<std::chrono::nanoseconds> away;  // the robot reboots once the connection is over
};

// Answers every request but stills and streams: / with a page, /rev.cgi and /Cmd.cgi with any
// number of commands, each command by its own path, else 404.
RoutedReply AnswerRequest(const HttpRequest& request, const Caller& caller, ServerContext& context);

// Nothing when the caller may; else the 401 that names the realm of the missing level.
std::optional<HttpResponse> RefuseBelow(Privilege required, const Caller& caller);

bool IsStillPath(const std::string& path);   // /Jpeg/CamImg<anything>.jpg
bool IsStreamPath(const std::string& path);  // /GetData.cgi

}  // namespace rovio_sfm::sim
