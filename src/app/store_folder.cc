#include "rovio_sfm/app/store_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace rovio_sfm {
namespace {

constexpr const char* kSideFiles[] = {"", "-wal", "-shm"};

// On the disk, a folder's names too.
void SyncFile(const std::filesystem::path& path) {
  const int file = open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  if (!synced) throw std::runtime_error(path.string() + ": cannot be written to the disk");
}

void RemoveStore(const std::filesystem::path& file) {
  for (const char* side : kSideFiles) std::filesystem::remove(file.string() + side);
}

// The log goes into the file itself, so that one rename moves the whole store.
void FoldLog(const std::filesystem::path& file) {
  try {
    MapStore(file, StoreAccess::kWrite);
  } catch (const StoreError&) {  // what is no store of ours has no log of ours
  }
}

void MoveStore(const std::filesystem::path& from, const std::filesystem::path& to) {
  FoldLog(from);
  for (const char* side : kSideFiles) {
    if (std::filesystem::exists(from.string() + side)) {
      std::filesystem::rename(from.string() + side, to.string() + side);
    }
  }
}

// A run that was replacing a store, and ended before it had written anything, took nothing away.
void ReplaceStore(const std::filesystem::path& file, const std::filesystem::path& replaced) {
  if (std::filesystem::exists(replaced)) {
    RemoveStore(file);
  } else {
    MoveStore(file, replaced);
  }
}

}  // namespace

std::filesystem::path StoreFolder::FileIn(const std::filesystem::path& folder) {
  return folder / "map.db";
}

std::filesystem::path StoreFolder::ReplacedIn(const std::filesystem::path& folder) {
  return folder / "map.db.replaced";
}

StoreFolder::StoreFolder(const std::filesystem::path& folder, ExistingStore existing,
                         const MapStoreOptions& options)
    : folder_(folder), options_(options) {
  const std::filesystem::path file = FileIn(folder);
  if (existing == ExistingStore::kRead) {
    store_ = std::make_unique<MapStore>(file, StoreAccess::kRead, options);
    return;
  }
  std::filesystem::create_directories(folder);
  const std::filesystem::path replaced = ReplacedIn(folder);
  const bool exists = std::filesystem::exists(file) || std::filesystem::exists(replaced);
  if (exists && existing == ExistingStore::kRefuse) {
    throw std::runtime_error(file.string() +
                             " exists; give --resume to go on with it, --overwrite to replace it");
  }
  lock_ = std::make_unique<FolderLock>(folder);
  if (!std::filesystem::exists(file) && std::filesystem::exists(replaced)) {
    MoveStore(replaced, file);
  }
  if (exists && existing == ExistingStore::kReplace) ReplaceStore(file, replaced);
  store_ = std::make_unique<MapStore>(file, StoreAccess::kCreate, options);
}

std::unique_ptr<FolderLock> LockStoreFile(const std::filesystem::path& store) {
  const std::filesystem::path file = std::filesystem::weakly_canonical(store);
  const std::filesystem::path folder = file.parent_path();
  if (file != StoreFolder::FileIn(folder) && file != StoreFolder::ReplacedIn(folder)) {
    return nullptr;
  }
  return std::make_unique<FolderLock>(folder);
}

void StoreFolder::DropReplaced() { RemoveStore(ReplacedIn(folder_)); }

std::filesystem::path StoreFolder::PutAside() {
  store_.reset();  // its log goes into the file itself
  std::filesystem::path aside;
  for (int i = 1; aside.empty() || std::filesystem::exists(aside); ++i) {
    aside = folder_ / ("map_" + std::to_string(i) + ".db");
  }
  std::filesystem::rename(FileIn(folder_), aside);
  return aside;
}

std::filesystem::path StoreFolder::StartAnew() {
  const std::filesystem::path aside = PutAside();
  store_ = std::make_unique<MapStore>(FileIn(folder_), StoreAccess::kCreate, options_);
  return aside;
}

std::filesystem::path StoreFolder::GoOnWith(const std::filesystem::path& other) {
  const std::filesystem::path copy = folder_ / "map.db.loaded";
  CopyStoreFile(other, copy);
  const std::filesystem::path aside = PutAside();
  std::filesystem::rename(copy, FileIn(folder_));
  store_ = std::make_unique<MapStore>(FileIn(folder_), StoreAccess::kWrite, options_);
  return aside;
}

void CopyStoreFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::filesystem::path half = to.string() + ".half";
  std::filesystem::remove(half);
  try {
    MapStore(from, StoreAccess::kRead).CopyTo(half);
    SyncFile(half);
    std::filesystem::rename(half, to);
    SyncFile(to.parent_path());
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(half, ignored);
    throw;
  }
}

}  // namespace rovio_sfm
