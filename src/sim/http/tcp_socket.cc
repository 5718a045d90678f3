#include "rovio_sfm/sim/http/tcp_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

namespace rovio_sfm::sim {
namespace {

// Waits for events; false on time-out or error.
bool Poll(int descriptor, short events, int timeout_ms) {
  pollfd entry{descriptor, events, 0};
  int ready = 0;
  do {
    ready = poll(&entry, 1, timeout_ms);
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

void Enable(int descriptor, int level, int option) {
  const int one = 1;
  setsockopt(descriptor, level, option, &one, sizeof(one));
}

bool BindAndListen(int descriptor, const sockaddr_in& address) {
  // A backlog deeper than the connection cap: surplus clients wait, as with the robot.
  constexpr int kBacklog = 64;
  return bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0 &&
         listen(descriptor, kBacklog) == 0;
}

int PortOf(int descriptor) {
  sockaddr_in bound{};
  socklen_t length = sizeof(bound);
  if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&bound), &length) != 0) return 0;
  return ntohs(bound.sin_port);
}

}  // namespace

TcpConnection::TcpConnection(int descriptor) : descriptor_(descriptor) {
  Enable(descriptor_, IPPROTO_TCP, TCP_NODELAY);
}

TcpConnection::~TcpConnection() { close(descriptor_); }

ReadStatus TcpConnection::Read(size_t max_bytes, int timeout_ms, std::string* received) {
  if (!Poll(descriptor_, POLLIN, timeout_ms)) return ReadStatus::kTimeout;
  std::vector<char> buffer(max_bytes);
  const ssize_t count = recv(descriptor_, buffer.data(), buffer.size(), 0);
  if (count < 0) return ReadStatus::kError;
  if (count == 0) return ReadStatus::kEnd;
  received->append(buffer.data(), static_cast<size_t>(count));
  return ReadStatus::kData;
}

bool TcpConnection::Write(std::string_view bytes, int timeout_ms) {
  while (!bytes.empty()) {
    if (!Poll(descriptor_, POLLOUT, timeout_ms)) return false;
    const ssize_t count =
        send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && errno != EAGAIN && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

bool TcpConnection::IsPeerGone() const {
  char byte = 0;
  const ssize_t count = recv(descriptor_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR);
}

void TcpConnection::Shutdown() { shutdown(descriptor_, SHUT_RDWR); }

void TcpConnection::ResetOnClose() {
  const linger reset{1, 0};
  setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &reset, sizeof(reset));
}

std::unique_ptr<TcpListener> TcpListener::Open(const std::string& address, int port,
                                               std::string* error) {
  sockaddr_in wanted{};
  wanted.sin_family = AF_INET;
  wanted.sin_port = htons(static_cast<uint16_t>(port));
  if (inet_pton(AF_INET, address.c_str(), &wanted.sin_addr) != 1) {
    *error = "not an IPv4 address: " + address;
    return nullptr;
  }
  const int descriptor = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) {
    *error = std::string("socket: ") + std::strerror(errno);
    return nullptr;
  }
  Enable(descriptor, SOL_SOCKET, SO_REUSEADDR);
  if (!BindAndListen(descriptor, wanted)) {
    *error = address + ":" + std::to_string(port) + ": " + std::strerror(errno);
    close(descriptor);
    return nullptr;
  }
  return std::unique_ptr<TcpListener>(new TcpListener(descriptor, PortOf(descriptor)));
}

TcpListener::~TcpListener() { close(descriptor_); }

std::unique_ptr<TcpConnection> TcpListener::Accept() {
  while (true) {
    const int descriptor = accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC);
    if (descriptor >= 0) return std::make_unique<TcpConnection>(descriptor);
    if (errno != EINTR && errno != ECONNABORTED) return nullptr;
  }
}

void TcpListener::Close() { shutdown(descriptor_, SHUT_RDWR); }

}  // namespace rovio_sfm::sim
