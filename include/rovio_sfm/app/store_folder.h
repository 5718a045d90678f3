#pragma once

#include <filesystem>
#include <memory>

#include "rovio_sfm/app/folder_lock.h"
#include "rovio_sfm/io/map_store.h"

namespace rovio_sfm {

// What becomes of the store that an output folder holds already.
enum class ExistingStore { kRefuse, kResume, kReplace, kRead };

// The maps of a folder on disk, held against every other process as long as this lives.
class StoreFolder {
 public:
  // Makes the folder, and opens or makes the store in it; kRead: opens it, and changes nothing;
  // kReplace: the store that is there is put aside as ReplacedIn until DropReplaced.
  // Throws std::runtime_error where a store is there and refused, another process maps into it, or
  // there is none to be read.
  StoreFolder(const std::filesystem::path& folder, ExistingStore existing,
              const MapStoreOptions& options = {});
  StoreFolder(const StoreFolder&) = delete;
  StoreFolder& operator=(const StoreFolder&) = delete;

  static std::filesystem::path FileIn(const std::filesystem::path& folder);
  // The store that a run replaces which has nothing yet to put there.
  static std::filesystem::path ReplacedIn(const std::filesystem::path& folder);
  MapStore& store() { return *store_; }
  const MapStore& store() const { return *store_; }
  bool IsWritten() const { return lock_ != nullptr; }

  // Once what was mapped instead is written.
  void DropReplaced();

  // Puts the store aside under another name in the folder, which it returns, and begins a new one.
  std::filesystem::path StartAnew();
  // The same, but goes on with a copy of another store. Throws StoreError where that is none of
  // this version, or cannot be copied; then all is as before.
  std::filesystem::path GoOnWith(const std::filesystem::path& other);

 private:
  std::filesystem::path PutAside();

  std::filesystem::path folder_;
  MapStoreOptions options_;
  std::unique_ptr<FolderLock> lock_;  // null: is only read; outlives the store
  std::unique_ptr<MapStore> store_;
};

// For who changes a store that is no part of a StoreFolder: holds the folder where the store is
// one that is mapped into, by its name; null: it is none. Throws as FolderLock does.
std::unique_ptr<FolderLock> LockStoreFile(const std::filesystem::path& store);

// A consistent copy of what was committed to a store, whoever writes into it; replaces a file that
// is there, in one step. Throws StoreError or std::runtime_error.
void CopyStoreFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace rovio_sfm
