#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <thread>
#include <utility>

namespace rovio_sfm {

// A server on the loopback that answers every connection with the same bytes and then ends the
// connection, or holds it open until the client goes. Remembers the last request.
class ScriptedServer {
 public:
  enum class Afterwards { kClose, kHold };

  ScriptedServer(std::string answer, Afterwards afterwards)
      : answer_(std::move(answer)), afterwards_(afterwards) {
    listener_ = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof(address));
    socklen_t length = sizeof(address);
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    port_ = ntohs(address.sin_port);
    listen(listener_, 8);
    thread_ = std::thread([this] { Serve(); });
  }

  ~ScriptedServer() {
    shutdown(listener_, SHUT_RDWR);
    thread_.join();
    close(listener_);
  }

  int Port() const { return port_; }
  int NumConnections() const { return num_connections_; }
  std::string LastRequest() const { return last_request_; }  // when the exchange is over

 private:
  void Serve() {
    while (true) {
      const int connection = accept(listener_, nullptr, nullptr);
      if (connection < 0) return;
      ++num_connections_;
      ServeOne(connection);
      close(connection);
    }
  }

  void ServeOne(int connection) {
    char buffer[4096];
    const ssize_t count = recv(connection, buffer, sizeof(buffer), 0);
    if (count <= 0) return;
    last_request_.assign(buffer, static_cast<size_t>(count));
    send(connection, answer_.data(), answer_.size(), MSG_NOSIGNAL);
    while (afterwards_ == Afterwards::kHold && recv(connection, buffer, sizeof(buffer), 0) > 0) {
    }
  }

  const std::string answer_;
  const Afterwards afterwards_;
  int listener_ = -1;
  int port_ = 0;
  std::atomic<int> num_connections_{0};
  std::string last_request_;
  std::thread thread_;
};

}  // namespace rovio_sfm
