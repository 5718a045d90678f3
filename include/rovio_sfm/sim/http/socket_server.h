#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <thread>

#include "rovio_sfm/sim/http/stop_signal.h"
#include "rovio_sfm/sim/http/tcp_socket.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

struct SocketServerOptions {
  std::string address = "127.0.0.1";  // IPv4; 0.0.0.0 lets the network in
  int port = 0;                       // 0 … 65535; 0 takes a free one
  int max_connections = 20;           // [1, 1000]; the robot's limit; more wait unanswered

  bool IsValid(std::string* error) const;
};

// Listens, and runs the handler once for each connection, on a thread of its own. cpp-httplib is no
// use for the robot's HTTP: it writes "HTTP/1.1" in every status line and refuses bare LF line
// ends. Stop (or the destructor) ends every connection and joins every thread.
class SocketServer {
 public:
  using Handler = std::function<void(TcpConnection&)>;

  SocketServer(SocketServerOptions options, Handler handler);
  ~SocketServer();

  bool Start(std::string* error);  // once
  void Stop();
  int port() const { return options_.port; }  // the real one after Start

  // The robot reboots: drops every connection, refuses clients for so long, then listens again on
  // the same port. Returns at once.
  void GoAway(std::chrono::nanoseconds duration);

  // Ends every connection now; new ones are welcome.
  void DropConnections();

 private:
  struct Session {
    std::unique_ptr<TcpConnection> connection;
    std::thread thread;
    bool finished = false;
  };

  void AcceptLoop();
  bool ReopenAfterAbsence();
  // Null when the server stops or goes away meanwhile.
  std::shared_ptr<TcpListener> WaitForFreePlace();
  int NumBusy() const REQUIRES(mutex_);
  void StartSession(std::unique_ptr<TcpConnection> connection);
  void RunSession(Session* session);
  void JoinSessions(bool all);

  SocketServerOptions options_;
  const Handler handler_;
  StopSignal stop_;
  std::thread accept_thread_;

  Mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<TcpListener> listener_ GUARDED_BY(mutex_);  // null while the robot is away
  std::list<std::unique_ptr<Session>> sessions_ GUARDED_BY(mutex_);
  std::chrono::nanoseconds absence_ GUARDED_BY(mutex_){0};
  bool stopping_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm::sim
