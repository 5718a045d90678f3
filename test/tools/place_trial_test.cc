#include "rovio_sfm/tools/place_trial.h"

#include <gtest/gtest.h>

#include "recognition/place_frames.h"
#include "tools/place_folder.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

PlaceImage ImageOf(const SyntheticRoom& room, uint32_t folder, uint32_t cam) {
  const FrameId id{{"folder_" + std::to_string(folder), folder, 0}, cam};
  return {"image", id, room.world().camera, room.FeaturesOf(cam)};
}

TEST(PlaceTrial, FindsEveryImageOfAKnownRoomByEachMethod) {
  const SyntheticRoom hall(1, 4), attic(2, 4);
  std::vector<PlaceImage> queries, database;
  for (uint32_t cam = 0; cam < 4; ++cam) {
    queries.push_back(ImageOf(hall, 0, cam));
    database.push_back(ImageOf(attic, 1, cam));
  }
  for (uint32_t cam = 0; cam < 4; ++cam) database.push_back(ImageOf(hall, 2, cam));
  const PlaceTrial trial = RunPlaceTrial(queries, database, ModelOf({&hall, &attic}), {}, {});
  for (const auto* answers : {&trial.fabmap, &trial.verified, &trial.tf_idf}) {
    ASSERT_EQ(answers->size(), 4u);
    for (const auto& answer : *answers) {
      ASSERT_TRUE(answer);
      EXPECT_GE(answer->other, 4u);
    }
  }
  EXPECT_EQ(trial.counters.matched_queries, 4u);
  EXPECT_GT(trial.bytes_per_place, 0.0);
}

TEST(PlaceTrial, ForeignRoomHasNoVerifiedAnswer) {
  const SyntheticRoom hall(1, 2), attic(2, 2);
  const PlaceTrial trial = RunPlaceTrial({ImageOf(hall, 0, 0)}, {ImageOf(attic, 1, 0)},
                                         ModelOf({&hall, &attic}), {}, {});
  EXPECT_TRUE(trial.fabmap[0]);
  EXPECT_FALSE(trial.verified[0]);
}

TEST(PlaceTrial, QueriesKnowOfThemselvesOnlyWhatComesWellBefore) {
  const SyntheticRoom hall(1, 4), attic(2, 4);
  const std::vector<PlaceImage> queries{ImageOf(hall, 0, 0), ImageOf(attic, 0, 1),
                                        ImageOf(hall, 0, 2), ImageOf(hall, 0, 3)};
  EXPECT_FALSE(KnowsImage(queries, 1, 0, 2));
  EXPECT_TRUE(KnowsImage(queries, 2, 0, 2));
  std::vector<PlaceImage> database = queries;
  database.push_back(ImageOf(attic, 1, 0));
  PlaceTrialOptions options;
  options.self_gap = 2;
  options.keep_scores = true;
  const PlaceTrial trial = RunPlaceTrial(queries, database, ModelOf({&hall, &attic}), {}, options);
  EXPECT_EQ(trial.fabmap[1]->other, 4u);
  EXPECT_EQ(trial.tf_idf[1]->other, 4u);
  EXPECT_EQ(trial.fabmap[2]->other, 0u);
  EXPECT_EQ(trial.tf_idf[2]->other, 0u);
  EXPECT_EQ(trial.verified[2]->other, 0u);
  EXPECT_EQ(trial.fabmap[3]->other, 0u);
  ASSERT_EQ(trial.scores.size(), 4u);
  ASSERT_EQ(trial.scores[2].size(), 5u);
  EXPECT_EQ(trial.scores[2][0], trial.fabmap[2]->score);
  EXPECT_LT(trial.scores[2][3], -1e300);  // comes later
}

TEST(PlaceTrial, ThePriorFollowsTheQueryBefore) {
  const SyntheticRoom hall(1, 4), attic(2, 4);
  std::vector<PlaceImage> queries, database;
  for (uint32_t cam = 0; cam < 2; ++cam) queries.push_back(ImageOf(hall, 0, cam));
  for (uint32_t cam = 0; cam < 4; ++cam) database.push_back(ImageOf(hall, 1, cam));
  for (uint32_t cam = 0; cam < 4; ++cam) database.push_back(ImageOf(attic, 2, cam));
  PlaceTrialOptions options;
  const auto model = ModelOf({&hall, &attic});
  const PlaceTrial without = RunPlaceTrial(queries, database, model, {}, options);
  options.use_prior = true;
  const PlaceTrial with = RunPlaceTrial(queries, database, model, {}, options);
  EXPECT_EQ(with.fabmap[0]->score, without.fabmap[0]->score);
  EXPECT_EQ(with.fabmap[1]->other, 1u);
  EXPECT_GT(with.fabmap[1]->score, without.fabmap[1]->score);
}

TEST(PlaceTrial, ExtractsAFolderWhateverTheThreads) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path(), 3, 1);
  PlaceImages images = ReadPlaceImages(folder.Path().string(), 1);
  const auto one = ExtractPlaceImages(&images, 5, {}, 1);
  const auto two = ExtractPlaceImages(&images, 5, {}, 2);
  ASSERT_EQ(one.size(), 3u);
  EXPECT_EQ(one[2].id.index, 2u);
  EXPECT_GT(one[2].features->keypoints.size(), 50u);
  EXPECT_EQ(one[2].features->descriptors.data, two[2].features->descriptors.data);
}

TEST(PlaceTrial, AnImageThatCannotBeReadCostsThatImage) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path(), 3, 1);
  std::ofstream(folder.Path() / "images/000001.png") << "no picture";
  PlaceImages images = ReadPlaceImages(folder.Path().string(), 1);
  const auto poses = images.poses;
  const auto extracted = ExtractPlaceImages(&images, 0, {}, 2);
  ASSERT_EQ(extracted.size(), 2u);
  EXPECT_EQ(extracted[1].id.index, 2u);
  EXPECT_EQ(images.indices, (std::vector<uint32_t>{0, 2}));
  ASSERT_EQ(images.poses.size(), 2u);
  EXPECT_EQ(images.poses[1]->translation, poses[2]->translation);
}

TEST(PlaceTrial, NoReadableImageIsAnError) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path(), 1, 1);
  std::ofstream(folder.Path() / "images/000000.png") << "no picture";
  PlaceImages images = ReadPlaceImages(folder.Path().string(), 1);
  EXPECT_THROW(ExtractPlaceImages(&images, 0, {}, 1), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
