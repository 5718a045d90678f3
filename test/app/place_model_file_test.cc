#include "rovio_sfm/app/place_model_file.h"

#include <gtest/gtest.h>

#include "places/random_place_model.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(PlaceModelFile, LoadsWhatWasSaved) {
  const TemporaryFolder folder;
  const PlaceModel model = RandomPlaceModel(20, 15, 1);
  SavePlaceModel(model, folder.Path() / "a.places", Overwrite::kRefuse);
  EXPECT_EQ(EncodePlaceModel(*LoadPlaceModel(folder.Path() / "a.places")), EncodePlaceModel(model));
}

TEST(PlaceModelFile, RefusesToReplaceUnlessAllowed) {
  const TemporaryFolder folder;
  folder.Write("a.places", "mine");
  const PlaceModel model = RandomPlaceModel(4, 3, 1);
  const auto save = [&] { SavePlaceModel(model, folder.Path() / "a.places", Overwrite::kRefuse); };
  EXPECT_NE(MessageOf(save).find("a.places"), std::string::npos);
}

TEST(PlaceModelFile, TheShippedModelLoadsAndIsSmall) {
  const std::filesystem::path path = ROVIO_SOURCE_DIR "/config/places/indoor.places";
  EXPECT_LE(std::filesystem::file_size(path), 12u << 20);
  const auto model = LoadPlaceModel(path);
  EXPECT_EQ(model->vocabulary.Words().type, DescriptorType::kSift);
  EXPECT_EQ(model->training_bags.size(), 554u);
}

TEST(PlaceModelFile, NamesTheFileThatIsMissingOrNoModel) {
  const TemporaryFolder folder;
  folder.Write("b.places", "something else");
  for (const char* name : {"a.places", "b.places"}) {
    const auto load = [&] { LoadPlaceModel(folder.Path() / name); };
    EXPECT_NE(MessageOf(load).find(name), std::string::npos);
  }
}

}  // namespace
}  // namespace rovio_sfm
