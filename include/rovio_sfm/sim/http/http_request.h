#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rovio_sfm/sim/http/tcp_socket.h"

namespace rovio_sfm::sim {

struct HttpRequest {
  std::string method;         // upper case as sent: GET, POST …
  std::string path;           // decoded, one leading slash
  std::string query;          // still encoded; for POST the body
  std::string target_query;   // still encoded; the part of the address after "?"
  std::string authorization;  // the header's value, empty without
  bool keep_alive = false;    // the client asked for it
  size_t content_length = 0;
};

// The limits of the robot's server. Larger heads get 400; a larger body is read, dropped and
// answered with a text line.
inline constexpr size_t kMaxHeaderLineBytes = 1024;
inline constexpr size_t kMaxHeadBytes = 1792;
inline constexpr size_t kMaxPostBytes = 10 * 1024;

// Reads a request's head (without the blank line at its end): tolerant of bare LF, several blanks,
// a missing version and "//" before the path. Nothing for what the robot answers with 400.
std::optional<HttpRequest> ParseRequestHead(std::string_view head);

enum class RequestStatus { kComplete, kBad, kPostTooLarge, kClosed };

// The requests of one connection, one after the other (pipelined ones too). Not thread-safe.
class RequestReader {
 public:
  // The time-outs of a request's first bytes and of the rest.
  RequestReader(TcpConnection& connection, int idle_timeout_ms, int timeout_ms);

  // Blocks for the next request; *request is valid with kComplete and kPostTooLarge.
  RequestStatus ReadNext(HttpRequest* request);

 private:
  RequestStatus ReadHead(std::string* head);
  RequestStatus ReadBody(HttpRequest* request);
  bool ReadMore(int timeout_ms);

  TcpConnection& connection_;
  const int idle_timeout_ms_, timeout_ms_;
  std::string pending_;  // received, not yet consumed
};

}  // namespace rovio_sfm::sim
