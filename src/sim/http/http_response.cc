#include "rovio_sfm/sim/http/http_response.h"

#include <ctime>

namespace rovio_sfm::sim {
namespace {

std::string FormatHttpDate(int64_t unix_time_ns) {
  const std::time_t seconds = static_cast<std::time_t>(unix_time_ns / 1'000'000'000);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[64];
  const size_t length = std::strftime(text, sizeof(text), "%a, %d %b %Y %H:%M:%S GMT", &utc);
  return std::string(text, length);
}

std::string ReasonOf(int status) {
  switch (status) {
    case 400:
      return "Bad Request";
    case 401:
      return "Unauthorized";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    default:
      return "Server Error";
  }
}

}  // namespace

std::string SerializeHead(const HttpResponse& response, const KeepAlive& keep_alive,
                          int64_t unix_time_ns, bool has_length) {
  std::string head = "HTTP/1.0 " + std::to_string(response.status) + " " + response.reason + "\r\n";
  head += "Date: " + FormatHttpDate(unix_time_ns) + "\r\nServer: WYM/1.0\r\n";
  if (keep_alive.enabled) {
    head += "Connection: Keep-Alive\r\nKeep-Alive: timeout=" +
            std::to_string(kKeepAliveTimeoutSeconds) +
            ", max=" + std::to_string(keep_alive.requests_left) + "\r\n";
  } else {
    head += "Connection: close\r\n";
  }
  if (response.no_cache) {
    head +=
        "Pragma: no-cache\r\nCache-Control: no-cache\r\n"
        "Expires: 01 Jan 1970 00:00:00 GMT\r\n";
  }
  head += response.extra_headers + "Content-Type: " + response.content_type + "\r\n";
  if (has_length) head += "Content-Length: " + std::to_string(response.body.size()) + "\r\n";
  return head + "\r\n";
}

HttpResponse ErrorPage(int status) {
  HttpResponse response;
  response.status = status;
  response.reason = ReasonOf(status);
  response.content_type = "text/html";
  response.no_cache = false;
  const std::string title = std::to_string(status) + " " + response.reason;
  response.body = "<HTML><HEAD><TITLE>" + title + "</TITLE></HEAD>\n<BODY><H1>" + title +
                  "</H1>\n</BODY></HTML>\n";
  return response;
}

HttpResponse LoginRequired(const std::string& realm) {
  HttpResponse response = ErrorPage(401);
  response.extra_headers = "WWW-Authenticate: Basic realm=\"" + realm + "\"\r\n";
  return response;
}

}  // namespace rovio_sfm::sim
