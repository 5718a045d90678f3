#pragma once

#include <functional>
#include <memory>
#include <string>

#include "rovio_sfm/app/web_request.h"

namespace rovio_sfm {

// What one client may cost.
struct WebLimits {
  int num_threads = 4;
  int max_waiting = 16;              // connections that wait for a thread; then nobody is accepted
  size_t max_request_bytes = 32768;  // request line, headers and body together
  size_t max_body_bytes = 4096;
  double request_s = 5.0;  // from the connection to the whole request
  double answer_s = 20.0;  // then to the whole answer taken
};

// Serves HTTP/1.1, one request a connection, on threads of its own, by the handler, which must be
// thread-safe. A client that sends or takes too slowly, or too much, is dropped. Adds headers that
// keep browsers from anything but the page itself. Stop (or the destructor) drops all clients and
// waits for handlers that run.
class WebServer {
 public:
  using Handler = std::function<WebAnswer(const WebRequest&)>;

  // Throws std::runtime_error that names address and port where it cannot listen.
  WebServer(const std::string& address, int port, Handler handler, const WebLimits& limits = {});
  ~WebServer();

  int port() const;  // the real one
  void Stop();

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace rovio_sfm
