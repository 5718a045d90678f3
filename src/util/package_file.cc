#include "rovio_sfm/util/package_file.h"

#include <system_error>

namespace rovio_sfm {

std::optional<std::filesystem::path> FindPackageFile(const std::filesystem::path& name) {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error);
  while (folder.has_parent_path() && folder != folder.parent_path()) {
    folder = folder.parent_path();
    const std::filesystem::path file = folder / "share/rovio_sfm" / name;
    if (std::filesystem::exists(file, error)) return file;
  }
  return std::nullopt;
}

}  // namespace rovio_sfm
