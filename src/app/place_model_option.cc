#include "rovio_sfm/app/place_model_option.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include "rovio_sfm/app/place_model_file.h"
#include "rovio_sfm/util/package_file.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

constexpr char kShipped[] = "config/places/indoor.places";

fs::path FindShipped() {
  if (const auto file = FindPackageFile(kShipped)) return *file;
  throw std::runtime_error(std::string("no share/rovio_sfm/") + kShipped +
                           " beside this program; name a place model, or none");
}

}  // namespace

std::shared_ptr<const PlaceModel> ReadPlaceModel(const std::string& file) {
  if (file == "none") return nullptr;
  return LoadPlaceModel(file.empty() ? FindShipped() : fs::path(file));
}

}  // namespace rovio_sfm
