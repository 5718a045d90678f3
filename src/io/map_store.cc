#include "rovio_sfm/io/map_store.h"

#include "rovio_sfm/io/map_store_schema.h"

namespace rovio_sfm {

MapStore::MapStore(const std::filesystem::path& path, StoreAccess access,
                   const MapStoreOptions& options)
    : options_(options),
      database_(path, access, options.vfs),
      frames_((OpenSchema(access, &database_), &database_)),
      sessions_(&database_, &frames_),
      merges_(&database_, &frames_),
      cache_(options.max_cache_bytes, [this](const FrameId& id) { return Fetch(id); }) {}

// A frame that cannot be read is one that is not there: mapping goes on without it.
std::shared_ptr<const FrameFeatures> MapStore::Fetch(const FrameId& id) const {
  try {
    return frames_.ReadFeatures(id);
  } catch (const StoreError& error) {
    read_error_ = error.what();
    return nullptr;
  }
}

void MapStore::BeginChanges() {
  if (!database_.IsInTransaction()) database_.Execute("BEGIN IMMEDIATE");
}

// What was begun and fails is taken back: half of a change is never committed.
bool MapStore::Write(const std::function<void()>& write) {
  if (!error_.empty()) return false;
  try {
    BeginChanges();
    write();
    return true;
  } catch (const StoreError& error) {
    error_ = error.what();
  }
  database_.RollBack();
  for (const FrameEvent& event : uncommitted_) unwritten_.Put(event);
  uncommitted_.clear();
  return false;
}

void MapStore::Put(const FrameEvent& event) {
  if (Write([&] { frames_.PutFrame(event, options_.keep_images); })) {
    uncommitted_.push_back(event);
    cache_.Put(event);
  } else {
    unwritten_.Put(event);
  }
}

bool MapStore::Commit(const std::function<void()>& put) {
  const bool written = Write([&] {
    put();
    database_.Execute("COMMIT");
  });
  if (!written) return false;
  ++num_commits_;
  uncommitted_.clear();
  return true;
}

std::shared_ptr<const FrameFeatures> MapStore::Get(const FrameId& id) const {
  if (auto features = unwritten_.Get(id)) return features;
  return cache_.Get(id);
}

MapRecord MapStore::Read(const FrameMaker& make) {
  return WithFileNamed(file(), [&] {
    return MapRecord{frames_.ReadDrives(), sessions_.Read(make), merges_.Read()};
  });
}

void MapStore::CopyTo(const std::filesystem::path& path) const {
  database_.Run("VACUUM INTO ?", path.string());
}

}  // namespace rovio_sfm
