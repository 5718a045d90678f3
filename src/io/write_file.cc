#include "rovio_sfm/io/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace rovio_sfm {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& what, int error) {
  throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(error));
}

// An open file descriptor, closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { ::close(value_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int Get() const { return value_; }

 private:
  int value_;
};

// A file of its own for every call, beside the target; its name in `path`.
int OpenTemporary(std::filesystem::path* path) {
  std::string name = path->string() + ".tmpXXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) Fail(*path, "cannot be opened", errno);
  *path = name;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(file, 0666 & ~mask) != 0) Fail(*path, "cannot be opened", errno);
  return file;
}

void WriteAndSync(const Descriptor& file, const std::filesystem::path& path,
                  const std::string& content) {
  for (size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(file.Get(), content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR) Fail(path, "cannot be written", errno);
    if (count > 0) done += static_cast<size_t>(count);
  }
  if (::fsync(file.Get()) != 0) Fail(path, "cannot be synced", errno);
}

void SyncFolder(const std::filesystem::path& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) Fail(folder, "cannot be opened", errno);
  const Descriptor directory(opened);
  if (::fsync(directory.Get()) != 0) Fail(folder, "cannot be synced", errno);
}

// Gives the temporary file its name; without overwrite, link(2) refuses an existing one atomically.
void Publish(const std::filesystem::path& temporary, const std::filesystem::path& path,
             Overwrite overwrite) {
  if (overwrite == Overwrite::kAllow) {
    if (::rename(temporary.c_str(), path.c_str()) != 0) Fail(path, "cannot be renamed to", errno);
    return;
  }
  if (::link(temporary.c_str(), path.c_str()) != 0) {
    if (errno == EEXIST) Fail(path, "not overwritten", EEXIST);
    Fail(path, "cannot be created", errno);
  }
  ::unlink(temporary.c_str());
}

}  // namespace

void WriteFile(const std::filesystem::path& path, const std::string& content, Overwrite overwrite) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (overwrite == Overwrite::kRefuse && std::filesystem::exists(path)) {
    Fail(path, "not overwritten", EEXIST);
  }
  std::filesystem::path temporary = path;
  const Descriptor file(OpenTemporary(&temporary));
  try {
    WriteAndSync(file, path, content);
    Publish(temporary, path, overwrite);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  SyncFolder(folder);
}

}  // namespace rovio_sfm
