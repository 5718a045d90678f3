#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace rovio_sfm::sim {

// A client that sends and receives bare bytes; every read gives up after 5 s.
class RawClient {
 public:
  explicit RawClient(int port) : descriptor_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ =
        connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }
  ~RawClient() { close(descriptor_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool is_connected() const { return connected_; }
  bool was_reset() const { return was_reset_; }

  void Send(const std::string& bytes) {
    send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  // Up to and with the mark; what came before the end if it does not come.
  std::string ReadUntil(const std::string& mark) {
    while (pending_.find(mark) == std::string::npos && ReadMore()) continue;
    const size_t at = pending_.find(mark);
    return Take(at == std::string::npos ? pending_.size() : at + mark.size());
  }
  std::string Read(size_t num_bytes) {
    while (pending_.size() < num_bytes && ReadMore()) continue;
    return Take(std::min(num_bytes, pending_.size()));
  }
  std::string ReadToEnd() {
    while (ReadMore()) continue;
    return Take(pending_.size());
  }
  // Whether anything arrives within so long.
  bool HasBytesWithin(int timeout_ms) {
    pollfd entry{descriptor_, POLLIN, 0};
    return !pending_.empty() || poll(&entry, 1, timeout_ms) > 0;
  }

 private:
  std::string Take(size_t num_bytes) {
    const std::string taken = pending_.substr(0, num_bytes);
    pending_.erase(0, num_bytes);
    return taken;
  }
  bool ReadMore() {
    pollfd entry{descriptor_, POLLIN, 0};
    if (poll(&entry, 1, 5000) <= 0) return false;
    char buffer[4096];
    const ssize_t count = recv(descriptor_, buffer, sizeof(buffer), 0);
    was_reset_ = was_reset_ || count < 0;
    if (count <= 0) return false;
    pending_.append(buffer, static_cast<size_t>(count));
    return true;
  }

  const int descriptor_;
  bool connected_ = false;
  bool was_reset_ = false;
  std::string pending_;
};

// One request on a connection of its own: everything the server sends back.
inline std::string Exchange(int port, const std::string& request) {
  RawClient client(port);
  client.Send(request);
  return client.ReadToEnd();
}

inline std::string BodyOf(const std::string& reply) {
  const size_t end = reply.find("\r\n\r\n");
  return end == std::string::npos ? "" : reply.substr(end + 4);
}

}  // namespace rovio_sfm::sim
