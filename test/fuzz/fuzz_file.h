#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

// A file in memory with these bytes, for what reads by path.
class FuzzFile {
 public:
  explicit FuzzFile(std::string_view bytes) : handle_(memfd_create("fuzz", 0)) {
    ROVIO_CHECK(handle_ >= 0, "memfd_create");
    const auto written = write(handle_, bytes.data(), bytes.size());
    ROVIO_CHECK(written == static_cast<ssize_t>(bytes.size()), "write");
  }
  ~FuzzFile() { close(handle_); }
  FuzzFile(const FuzzFile&) = delete;
  FuzzFile& operator=(const FuzzFile&) = delete;

  std::filesystem::path Path() const { return "/proc/self/fd/" + std::to_string(handle_); }

 private:
  const int handle_;
};

}  // namespace rovio_sfm
