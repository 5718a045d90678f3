#include "rovio_sfm/sim/config_folder.h"

#include <filesystem>
#include <optional>
#include <stdexcept>

#include "rovio_sfm/util/package_file.h"

namespace rovio_sfm::sim {
namespace {

namespace fs = std::filesystem;

bool IsConfigFolder(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "worlds", error) && fs::is_directory(folder / "tours", error);
}

}  // namespace

std::string FindConfigFolder(const std::string& asked) {
  const std::optional<fs::path> shipped = FindPackageFile("config");
  const std::string folder = asked.empty() && shipped ? shipped->string() : asked;
  if (folder.empty()) {
    throw std::runtime_error("no share/rovio_sfm/config beside this program; name a folder");
  }
  if (!IsConfigFolder(folder)) {
    throw std::runtime_error(folder + ": expected a folder with worlds/ and tours/");
  }
  return folder;
}

}  // namespace rovio_sfm::sim
