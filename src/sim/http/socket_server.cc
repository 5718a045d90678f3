#include "rovio_sfm/sim/http/socket_server.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/util/log.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {

bool SocketServerOptions::IsValid(std::string* error) const {
  OptionChecker check("socket", error);
  check.Range("port", port, 0, 65535);
  check.Range("max_connections", max_connections, 1, 1000);
  return check.Passed();
}

SocketServer::SocketServer(SocketServerOptions options, Handler handler)
    : options_(std::move(options)), handler_(std::move(handler)) {}

SocketServer::~SocketServer() { Stop(); }

bool SocketServer::Start(std::string* error) {
  if (!options_.IsValid(error)) return false;
  std::shared_ptr<TcpListener> listener = TcpListener::Open(options_.address, options_.port, error);
  if (listener == nullptr) return false;
  options_.port = listener->port();
  {
    const MutexLock lock(mutex_);
    listener_ = std::move(listener);
  }
  accept_thread_ = std::thread([this] { AcceptLoop(); });
  return true;
}

void SocketServer::Stop() {
  stop_.Request();
  {
    const MutexLock lock(mutex_);
    stopping_ = true;
    if (listener_ != nullptr) listener_->Close();
    changed_.notify_all();
  }
  if (accept_thread_.joinable()) accept_thread_.join();
  DropConnections();
  JoinSessions(true);
}

void SocketServer::GoAway(std::chrono::nanoseconds duration) {
  const MutexLock lock(mutex_);
  absence_ = std::max(absence_, duration);
  if (listener_ != nullptr) listener_->Close();
  changed_.notify_all();
}

void SocketServer::DropConnections() {
  const MutexLock lock(mutex_);
  for (const auto& session : sessions_) {
    if (session->connection != nullptr) session->connection->Shutdown();
  }
}

void SocketServer::AcceptLoop() {
  while (true) {
    std::unique_ptr<TcpConnection> connection;
    if (const auto listener = WaitForFreePlace()) connection = listener->Accept();
    if (stop_.IsRequested()) return;
    if (connection != nullptr) {
      StartSession(std::move(connection));
    } else if (!ReopenAfterAbsence()) {
      return;
    }
  }
}

int SocketServer::NumBusy() const {
  int num_busy = 0;
  for (const auto& session : sessions_) num_busy += session->finished ? 0 : 1;
  return num_busy;
}

std::shared_ptr<TcpListener> SocketServer::WaitForFreePlace() {
  JoinSessions(false);
  const MutexLock lock(mutex_);
  while (!stopping_ && absence_.count() == 0 && NumBusy() >= options_.max_connections) {
    changed_.wait(mutex_);
  }
  return stopping_ || absence_.count() > 0 ? nullptr : listener_;
}

// False when the server stops meanwhile, or the port is lost.
bool SocketServer::ReopenAfterAbsence() {
  std::chrono::nanoseconds absence{0};
  {
    const MutexLock lock(mutex_);
    absence = std::exchange(absence_, std::chrono::nanoseconds{0});
    listener_.reset();
  }
  DropConnections();
  JoinSessions(true);
  // The minimum keeps a failing accept (no descriptors left) from spinning.
  if (stop_.WaitFor(std::max<std::chrono::nanoseconds>(absence, std::chrono::milliseconds(20)))) {
    return false;
  }
  std::string error;
  auto listener = TcpListener::Open(options_.address, options_.port, &error);
  if (listener == nullptr) {
    LogError("the simulated robot cannot come back: " + error);
    return false;
  }
  const MutexLock lock(mutex_);
  listener_ = std::move(listener);
  return !stopping_;
}

void SocketServer::StartSession(std::unique_ptr<TcpConnection> connection) {
  auto session = std::make_unique<Session>();
  session->connection = std::move(connection);
  Session* const raw = session.get();
  const MutexLock lock(mutex_);
  raw->thread = std::thread([this, raw] { RunSession(raw); });
  sessions_.push_back(std::move(session));
}

void SocketServer::RunSession(Session* session) {
  handler_(*session->connection);
  const MutexLock lock(mutex_);
  session->connection.reset();
  session->finished = true;
  changed_.notify_all();
}

// Joins the finished sessions, or waits for all.
void SocketServer::JoinSessions(bool all) {
  std::list<std::unique_ptr<Session>> ended;
  {
    const MutexLock lock(mutex_);
    for (auto it = sessions_.begin(); it != sessions_.end();) {
      const auto next = std::next(it);
      if (all || (*it)->finished) ended.splice(ended.end(), sessions_, it);
      it = next;
    }
  }
  for (const auto& session : ended) session->thread.join();
}

}  // namespace rovio_sfm::sim
