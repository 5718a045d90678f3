#pragma once

#include <filesystem>
#include <string>

namespace rovio_sfm {

enum class Overwrite { kRefuse, kAllow };

// The calls by which files come to the disk; tests put a recording disk in their place. Each throws
// std::runtime_error with path and cause.
class FileLayer {
 public:
  virtual ~FileLayer() = default;
  virtual bool Exists(const std::filesystem::path& path) = 0;
  // Makes or empties the file, writes all of content and waits until that is on the disk.
  virtual void WriteAndSync(const std::filesystem::path& path, const std::string& content) = 0;
  virtual void Rename(const std::filesystem::path& from, const std::filesystem::path& to) = 0;
  // A second name; refuses one that is there.
  virtual void Link(const std::filesystem::path& from, const std::filesystem::path& to) = 0;
  virtual void Remove(const std::filesystem::path& path) noexcept = 0;
  virtual void SyncFolder(const std::filesystem::path& folder) = 0;
};
FileLayer& SystemFiles();

// Writes all of content or nothing: temporary file beside the target, fsync, rename, fsync of the
// folder. Throws std::runtime_error with path and cause; refuses an existing file unless allowed.
void WriteFile(const std::filesystem::path& path, const std::string& content, Overwrite overwrite,
               FileLayer& files = SystemFiles());

}  // namespace rovio_sfm
