#pragma once

#include <cstdint>
#include <string>

namespace rovio_sfm::sim {

struct HttpResponse {
  int status = 200;
  std::string reason = "OK";
  std::string content_type = "text/plain";
  std::string extra_headers;  // complete lines
  std::string body;
  bool no_cache = true;  // Pragma, Cache-Control and Expires, as on every CGI and JPEG
};

// How the connection goes on after the reply.
struct KeepAlive {
  bool enabled = false;
  int requests_left = 0;  // announced as max=
};

// The robot's limits as announced: Keep-Alive: timeout=3600, max=108000.
inline constexpr int kKeepAliveTimeoutSeconds = 3600;
inline constexpr int kKeepAliveRequests = 108000;

// Status line (always HTTP/1.0), headers and the blank line. has_length: false for endless bodies.
std::string SerializeHead(const HttpResponse& response, const KeepAlive& keep_alive,
                          int64_t unix_time_ns, bool has_length);

// The short HTML page of 400, 403, 404 and 500.
HttpResponse ErrorPage(int status);

// 401 with the realm that the robot asks for.
HttpResponse LoginRequired(const std::string& realm);

}  // namespace rovio_sfm::sim
