#pragma once

#include <filesystem>

namespace rovio_sfm {

// Holds a folder's map.db against every other process as long as this lives, and goes with the
// process, however that ends.
class FolderLock {
 public:
  // The folder must exist. Throws std::runtime_error where another process maps into it, or the
  // lock cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace rovio_sfm
