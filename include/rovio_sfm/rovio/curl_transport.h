#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "rovio_sfm/rovio/http_transport.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Login of HTTP Basic. Empty: none is sent.
struct Credentials {
  std::string user;
  std::string password;
};

// How long an answer of a robot may take.
struct HttpLimits {
  double connect_timeout_s = 2.0;
  double first_byte_timeout_s = 3.0;
  double between_bytes_timeout_s = 2.0;
  double total_timeout_s = 5.0;
  int min_bytes_per_s = 500;
  int min_speed_window_s = 5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("connect_timeout_s", connect_timeout_s, 0.05, 600.0, "");
    table.AddNumber("first_byte_timeout_s", first_byte_timeout_s, 0.05, 600.0,
                    "from the request to the first byte of the answer");
    table.AddNumber("between_bytes_timeout_s", between_bytes_timeout_s, 0.05, 600.0, "of a pause");
    table.AddNumber("total_timeout_s", total_timeout_s, 0.05, 600.0, "of all but the stream");
    table.AddNumber("min_bytes_per_s", min_bytes_per_s, 0, 1e9, "of the stream; 0: no minimum");
    table.AddNumber("min_speed_window_s", min_speed_window_s, 1, 600, "");
  }
};

// A name or an IPv4 address; no scheme, path, port or user.
bool IsHostName(const std::string& host);

struct CurlTransportOptions : HttpLimits {
  std::string host;
  int port = 80;
  size_t max_header_bytes = 8192;
  size_t max_header_lines = 64;

  void DescribeAddress(OptionTable& table) {
    table.AddText("host", host, "name or IPv4 address of the robot", OptionUse::kRequired);
    table.AddRule("host", IsHostName(host), "a name or IPv4 address, without scheme, port or path");
    table.AddNumber("port", port, 1, 65535, "");
  }

  void DescribeOptions(OptionTable& table) {
    DescribeAddress(table);
    HttpLimits::DescribeOptions(table);
  }
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
