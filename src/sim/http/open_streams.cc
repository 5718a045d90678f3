#include "rovio_sfm/sim/http/open_streams.h"

#include <utility>

namespace rovio_sfm::sim {

OpenStreams::Entry::Entry(OpenStreams& streams, std::string path, std::string query,
                          TcpConnection& connection)
    : streams_(streams), path_(std::move(path)), query_(std::move(query)), connection_(connection) {
  const MutexLock lock(streams_.mutex_);
  streams_.entries_.push_back(this);
}

OpenStreams::Entry::~Entry() {
  const MutexLock lock(streams_.mutex_);
  streams_.entries_.remove(this);
}

int OpenStreams::Drop(const std::string& path, const std::string& query) {
  const MutexLock lock(mutex_);
  int num_dropped = 0;
  for (Entry* const entry : entries_) {
    if (entry->path_ != path || entry->query_ != query) continue;
    entry->connection_.Shutdown();
    ++num_dropped;
  }
  return num_dropped;
}

}  // namespace rovio_sfm::sim
