#include "rovio_sfm/sim/config_folder.h"

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace rovio_sfm::sim {
namespace {

namespace fs = std::filesystem;

bool IsConfigFolder(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "worlds", error) && fs::is_directory(folder / "tours", error);
}

void AddParents(fs::path folder, const fs::path& suffix, std::vector<fs::path>* candidates) {
  for (int level = 0; level < 6; ++level) {
    candidates->push_back(folder / suffix);
    if (!folder.has_parent_path() || folder == folder.parent_path()) return;
    folder = folder.parent_path();
  }
}

}  // namespace

std::string FindConfigFolder(const std::string& asked) {
  std::vector<fs::path> candidates;
  if (!asked.empty()) {
    candidates.push_back(asked);
  } else {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) AddParents(program.parent_path(), "share/rovio_sfm/config", &candidates);
    if (!error) AddParents(program.parent_path(), "config", &candidates);
    AddParents(fs::current_path(error), "config", &candidates);
    candidates.push_back(ROVIO_SOURCE_DIR "/config");
  }
  std::string tried;
  for (const fs::path& candidate : candidates) {
    if (IsConfigFolder(candidate)) return candidate.string();
    tried += "\n  " + candidate.string();
  }
  throw std::runtime_error("no folder with worlds/ and tours/; looked at" + tried);
}

}  // namespace rovio_sfm::sim
