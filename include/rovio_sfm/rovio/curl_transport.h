#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "rovio_sfm/rovio/http_transport.h"

namespace rovio_sfm {

// Login of HTTP Basic. Empty: none is sent.
struct Credentials {
  std::string user;
  std::string password;
};

struct CurlTransportOptions {
  std::string host;  // a name or an IPv4 address; no scheme, path, port or user
  int port = 80;
  double connect_timeout_s = 2.0;
  double first_byte_timeout_s = 3.0;     // from the request to the first byte of the answer
  double between_bytes_timeout_s = 2.0;  // longest pause within an answer
  double total_timeout_s = 5.0;          // of a Get; a Stream has none
  int min_bytes_per_s = 500;             // of a Stream, over min_speed_window_s; 0: no minimum
  int min_speed_window_s = 5;
  size_t max_header_bytes = 8192;
  size_t max_header_lines = 64;

  bool IsValid(std::string* error) const;
};

// HttpTransport by libcurl: http only, no redirects, no proxy, every wait bounded, everything that
// arrives capped, lengths that contradict each other refused. Keeps its connection when the robot
// does. Credentials stay in this object: they reach no URL and no message.
class CurlTransport : public HttpTransport {
 public:
  CurlTransport(const CurlTransportOptions& options, const Credentials& credentials);
  ~CurlTransport() override;

  HttpResponse Get(const std::string& target, size_t max_body_bytes) override;
  HttpResponse Stream(const std::string& target, const StreamReceiver& receiver) override;
  void Cancel() override;

 private:
  struct Handles;
  struct Exchange;

  HttpResponse Perform(const std::string& target, Exchange* exchange);
  void DriveUntilDone(Exchange* exchange);
  void Prepare(const std::string& target, Exchange* exchange);

  const CurlTransportOptions options_;
  const std::unique_ptr<Handles> handles_;
  std::atomic<bool> is_cancelled_{false};
};

}  // namespace rovio_sfm
