#include "rovio_sfm/app/place_model_option.h"

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "rovio_sfm/app/place_model_file.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

constexpr char kShipped[] = "config/places/indoor.places";

// The shipped file of an installed program (PREFIX/lib/rovio_sfm/PROGRAM) or of the sources.
fs::path FindShipped() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  std::vector<fs::path> folders;
  if (!error) {
    const fs::path prefix = program.parent_path().parent_path().parent_path();
    folders = {prefix / "share/rovio_sfm", prefix.parent_path()};
  }
  folders.push_back(ROVIO_SOURCE_DIR);
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / kShipped, error)) return folder / kShipped;
  }
  throw std::runtime_error(std::string("no ") + kShipped +
                           " beside this program; name a place model, or none");
}

}  // namespace

std::shared_ptr<const PlaceModel> ReadPlaceModel(const std::string& file) {
  if (file == "none") return nullptr;
  return LoadPlaceModel(file.empty() ? FindShipped() : fs::path(file));
}

}  // namespace rovio_sfm
