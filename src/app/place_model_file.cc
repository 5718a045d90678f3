#include "rovio_sfm/app/place_model_file.h"

#include "rovio_sfm/io/text_file.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxModelBytes = 64u << 20;

}  // namespace

std::shared_ptr<const PlaceModel> LoadPlaceModel(const std::filesystem::path& path) {
  return std::make_shared<const PlaceModel>(
      DecodePlaceModel(ReadBytes(path, kMaxModelBytes), path.string()));
}

void SavePlaceModel(const PlaceModel& model, const std::filesystem::path& path,
                    Overwrite overwrite) {
  WriteFile(path, EncodePlaceModel(model), overwrite);
}

}  // namespace rovio_sfm
