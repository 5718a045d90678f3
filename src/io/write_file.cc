#include "rovio_sfm/io/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace rovio_sfm {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& what, int error) {
  throw std::system_error(error, std::generic_category(), path.string() + ": " + what);
}

// An open file descriptor, closed when it goes.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags)
      : value_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {
    if (value_ < 0) Fail(path, "cannot be opened", errno);
  }
  ~Descriptor() { ::close(value_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int Get() const { return value_; }

 private:
  int value_;
};

// The system's own calls.
class SystemFileLayer final : public FileLayer {
 public:
  bool Exists(const std::filesystem::path& path) override { return std::filesystem::exists(path); }
  void WriteAndSync(const std::filesystem::path& path, const std::string& content) override {
    const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
    for (size_t done = 0; done < content.size();) {
      const ssize_t count = ::write(file.Get(), content.data() + done, content.size() - done);
      if (count < 0 && errno != EINTR) Fail(path, "cannot be written", errno);
      if (count > 0) done += static_cast<size_t>(count);
    }
    if (::fsync(file.Get()) != 0) Fail(path, "cannot be synced", errno);
  }
  void Rename(const std::filesystem::path& from, const std::filesystem::path& to) override {
    if (::rename(from.c_str(), to.c_str()) != 0) Fail(to, "cannot be renamed to", errno);
  }
  void Link(const std::filesystem::path& from, const std::filesystem::path& to) override {
    if (::link(from.c_str(), to.c_str()) == 0) return;
    if (errno == EEXIST) Fail(to, "not overwritten", EEXIST);
    Fail(to, "cannot be created", errno);
  }
  void Remove(const std::filesystem::path& path) noexcept override { ::unlink(path.c_str()); }
  void SyncFolder(const std::filesystem::path& folder) override {
    const Descriptor directory(folder, O_RDONLY | O_DIRECTORY);
    if (::fsync(directory.Get()) != 0) Fail(folder, "cannot be synced", errno);
  }
};

// A file of its own for every call, of every process.
std::filesystem::path TemporaryBeside(const std::filesystem::path& path) {
  static std::atomic<uint64_t> num_calls{0};
  return path.string() + ".tmp" + std::to_string(::getpid()) + "_" + std::to_string(++num_calls);
}

// Gives the temporary file its name; without overwrite, an existing one is refused atomically.
void Publish(const std::filesystem::path& temporary, const std::filesystem::path& path,
             Overwrite overwrite, FileLayer& files) {
  if (overwrite == Overwrite::kAllow) return files.Rename(temporary, path);
  files.Link(temporary, path);
  files.Remove(temporary);
}

}  // namespace

FileLayer& SystemFiles() {
  static SystemFileLayer files;
  return files;
}

void WriteFile(const std::filesystem::path& path, const std::string& content, Overwrite overwrite,
               FileLayer& files) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (overwrite == Overwrite::kRefuse && files.Exists(path)) {
    Fail(path, "not overwritten", EEXIST);
  }
  const std::filesystem::path temporary = TemporaryBeside(path);
  try {
    files.WriteAndSync(temporary, content);
    Publish(temporary, path, overwrite, files);
  } catch (...) {
    files.Remove(temporary);
    throw;
  }
  files.SyncFolder(folder);
}

}  // namespace rovio_sfm
