#include "rovio_sfm/app/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>

namespace rovio_sfm {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "map.db.lock";
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0) throw std::runtime_error(path.string() + ": cannot be made or opened");
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw std::runtime_error(folder.string() + ": another process maps into this folder");
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace rovio_sfm
