#include "rovio_sfm/sim/http/rovio_http_server.h"

#include <utility>

#include "rovio_sfm/sim/http/capture_loop.h"
#include "rovio_sfm/sim/http/serve_connection.h"
#include "rovio_sfm/sim/http/sim_endpoint.h"

namespace rovio_sfm::sim {

bool RovioHttpServerOptions::IsValid(std::string* error) const {
  return socket.IsValid(error) && face.IsValid(error);
}

RovioHttpServer::RovioHttpServer(const RovioHttpServerOptions& options, RobotBackend& robot,
                                 Clock now_ns)
    : options_(options), context_(options.face, robot, std::move(now_ns)) {
  sockets_ = std::make_unique<SocketServer>(options_.socket, [this](TcpConnection& connection) {
    ServeConnection(connection, context_,
                    [this](std::chrono::nanoseconds away) { sockets_->GoAway(away); });
  });
}

RovioHttpServer::~RovioHttpServer() { Stop(); }

bool RovioHttpServer::Start(std::string* error) {
  return options_.IsValid(error) && sockets_->Start(error);
}

void RovioHttpServer::StartCapturing() {
  capture_thread_ = std::thread([this] { RunCaptureLoop(context_); });
}

bool RovioHttpServer::WaitForPictureDemand() { return context_.frames.WaitForDemand(); }

bool RovioHttpServer::CaptureForNextClient() {
  return WaitForPictureDemand() && CaptureOnce(context_);
}

bool RovioHttpServer::SetQuirk(const std::string& name, double value, std::string* error) {
  std::string reason;
  const auto away = ApplyQuirk(name, value, context_, &reason);
  if (away) sockets_->GoAway(*away);
  if (!reason.empty()) *error = reason;
  return reason.empty();
}

void RovioHttpServer::Stop() {
  context_.stop.Request();
  context_.frames.Close();
  sockets_->Stop();
  if (capture_thread_.joinable()) capture_thread_.join();
}

}  // namespace rovio_sfm::sim
