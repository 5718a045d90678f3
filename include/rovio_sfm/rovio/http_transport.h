#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace rovio_sfm {

// Why no whole answer came; kNone when one did, whatever its status.
enum class HttpFault {
  kNone,
  kConnect,      // no connection: refused, unreachable, no such host, or in time
  kTimeout,      // no first byte, or a pause, longer than allowed
  kTooSlow,      // fewer bytes a second than asked for
  kTooLarge,     // header or body above its cap
  kMalformed,    // no HTTP, or lengths that contradict each other
  kInterrupted,  // the connection ended in the middle
  kCancelled     // by Cancel(), or by a receiver that wanted no more
};

const char* NameOf(HttpFault fault);

struct HttpResponse {
  HttpFault fault = HttpFault::kNone;
  std::string message;  // for people, when there is a fault; never holds credentials
  int status = 0;       // 0 when no status line came
  std::string content_type;
  std::string body;              // of Get; empty for Stream
  double body_duration_s = 0.0;  // from the first byte of the answer to the last

  bool IsOk() const { return fault == HttpFault::kNone && status == 200; }
};

// What Stream hands on. Each returns false to end the stream.
struct StreamReceiver {
  std::function<bool(int status, const std::string& content_type)> on_header;
  std::function<bool(std::string_view bytes)> on_bytes;
};

// GET requests to one robot. Targets begin with '/'. Use from one thread at a time, but Cancel from
// any: it ends the request under way and all later ones.
class HttpTransport {
 public:
  virtual ~HttpTransport() = default;

  virtual HttpResponse Get(const std::string& target, size_t max_body_bytes) = 0;
  virtual HttpResponse Stream(const std::string& target, const StreamReceiver& receiver) = 0;
  virtual void Cancel() = 0;
};

}  // namespace rovio_sfm
