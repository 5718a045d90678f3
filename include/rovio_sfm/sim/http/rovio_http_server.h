#pragma once

#include <memory>
#include <string>
#include <thread>

#include "rovio_sfm/sim/http/robot_access.h"
#include "rovio_sfm/sim/http/server_context.h"
#include "rovio_sfm/sim/http/socket_server.h"
#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

struct RovioHttpServerOptions {
  SocketServerOptions socket;
  HttpFaceOptions face;

  bool IsValid(std::string* error) const;
};

// The HTTP face of a robot, as the real one's, quirks included. The robot must outlive the server.
// Thread-safe but for Start, StartCapturing and Stop.
class RovioHttpServer {
 public:
  RovioHttpServer(const RovioHttpServerOptions& options, RobotBackend& robot, Clock now_ns);
  ~RovioHttpServer();

  bool Start(std::string* error);  // once; false when the port is taken or an option is wrong
  int port() const { return sockets_->port(); }

  // Pictures come by themselves, at the frame rate by real time. Without it (tests, simulations in
  // lock step) they come one by one from CaptureForNextClient.
  void StartCapturing();

  // Blocks until a client waits for a picture; false once the server has stopped.
  bool WaitForPictureDemand();

  // The same, then takes a picture; false when none came.
  bool CaptureForNextClient();

  bool SetQuirk(const std::string& name, double value, std::string* error);

  // Ends all connections and joins all threads.
  void Stop();

 private:
  const RovioHttpServerOptions options_;
  ServerContext context_;
  std::unique_ptr<SocketServer> sockets_;
  std::thread capture_thread_;
};

}  // namespace rovio_sfm::sim
