#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace rovio_sfm::sim {

enum class ReadStatus { kData, kEnd, kTimeout, kError };

// One accepted connection; owns its descriptor. One thread reads and writes; Shutdown may come from
// any thread while the object lives.
class TcpConnection {
 public:
  explicit TcpConnection(int descriptor);
  ~TcpConnection();
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;

  // Appends what has arrived, at most max_bytes, to *received.
  ReadStatus Read(size_t max_bytes, int timeout_ms, std::string* received);

  // Sends all bytes; false when the peer is gone or takes nothing for timeout_ms.
  bool Write(std::string_view bytes, int timeout_ms);

  // Whether the peer has closed; does not block and takes no bytes.
  bool IsPeerGone() const;

  // Ends reads and writes, blocked ones too.
  void Shutdown();

  // Makes the destructor send a reset instead of an orderly end.
  void ResetOnClose();

 private:
  const int descriptor_;
};

// A listening socket. Accept is called by one thread; Close by any.
class TcpListener {
 public:
  // Port 0 takes a free one. Nothing when the address is malformed or taken, with the reason.
  static std::unique_ptr<TcpListener> Open(const std::string& address, int port,
                                           std::string* error);
  ~TcpListener();
  TcpListener(const TcpListener&) = delete;
  TcpListener& operator=(const TcpListener&) = delete;

  int port() const { return port_; }

  // Blocks; null once the listener is closed.
  std::unique_ptr<TcpConnection> Accept();

  // Ends Accept; further clients are refused once the object is gone.
  void Close();

 private:
  TcpListener(int descriptor, int port) : descriptor_(descriptor), port_(port) {}

  const int descriptor_;
  const int port_;
};

}  // namespace rovio_sfm::sim
