#pragma once

#include <list>
#include <string>

#include "rovio_sfm/sim/http/tcp_socket.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

// The endless replies that are being sent, so that DropData.cgi can cut them. Thread-safe.
class OpenStreams {
 public:
  // Lists a stream for as long as the entry lives; the connection must outlive the entry.
  class Entry {
   public:
    Entry(OpenStreams& streams, std::string path, std::string query, TcpConnection& connection);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

   private:
    friend class OpenStreams;
    OpenStreams& streams_;
    const std::string path_;
    const std::string query_;
    TcpConnection& connection_;
  };

  // Cuts the streams of exactly this path and (still encoded) query; returns how many.
  int Drop(const std::string& path, const std::string& query);

 private:
  Mutex mutex_;
  std::list<Entry*> entries_ GUARDED_BY(mutex_);
};

}  // namespace rovio_sfm::sim
