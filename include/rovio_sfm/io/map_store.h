#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/io/map_store_frames.h"
#include "rovio_sfm/io/map_store_merges.h"
#include "rovio_sfm/io/map_store_sessions.h"
#include "rovio_sfm/scene/frame_cache.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/map_record.h"
#include "rovio_sfm/scene/memory_frame_store.h"

namespace rovio_sfm {

struct MapStoreOptions {
  bool keep_images = true;             // the JPEGs that frame events bring
  size_t max_cache_bytes = 96u << 20;  // of features and descriptors in memory
  std::string vfs;                     // by which SQLite reaches files; empty: as the system does
};

// All maps of a folder in one SQLite file (design 5.5; docs/map_store.md): frames as they arrive,
// and what mapping makes of them at each commit. What was committed survives the process and the
// machine. Where the file cannot be written any more mapping goes on in memory, and error() says
// since when; what was committed stays. Thread-compatible.
class MapStore final : public FrameStore {
 public:
  // Throws StoreError where the file cannot be opened, or is no store of this version.
  MapStore(const std::filesystem::path& path, StoreAccess access,
           const MapStoreOptions& options = {});

  // Into the next commit.
  void Put(const FrameEvent& event) override;
  // Calls what puts the rest, then commits: all of it is on the disk when this returns true.
  bool Commit(const std::function<void()>& put);
  // To be called by that.
  StoredFrames& frames() { return frames_; }
  StoredSessions& sessions() { return sessions_; }
  StoredMerges& merges() { return merges_; }
  // Why nothing is written any more, or a frame could not be read; empty: all is well.
  const std::string& error() const { return error_.empty() ? read_error_ : error_; }

  std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const override;
  // All maps as they were committed last. Throws StoreError.
  MapRecord Read(const FrameMaker& make);
  // A consistent copy of all that was committed, in a new file. Throws StoreError.
  void CopyTo(const std::filesystem::path& path) const;

  const std::string& file() const { return database_.file(); }
  uint64_t num_commits() const { return num_commits_; }
  // Frames put since the last commit.
  size_t num_uncommitted() const { return uncommitted_.size(); }

 private:
  void BeginChanges();
  bool Write(const std::function<void()>& write);
  std::shared_ptr<const FrameFeatures> Fetch(const FrameId& id) const;

  MapStoreOptions options_;
  mutable StoreDatabase database_;
  StoredFrames frames_;
  StoredSessions sessions_;
  StoredMerges merges_;
  FrameCache cache_;
  uint64_t num_commits_ = 0;
  std::vector<FrameEvent> uncommitted_;
  std::string error_;               // of writing
  mutable std::string read_error_;  // of Get
  MemoryFrameStore unwritten_;      // what came since the error
};

}  // namespace rovio_sfm
