#include "rovio_sfm/tools/training_images.h"

#include "tools/training_folder.h"

namespace rovio_sfm {
namespace {

TrainingFeatures Extract(const std::vector<std::filesystem::path>& images, int num_threads) {
  const TrainPlacesOptions options = QuickTraining();
  Executor executor(num_threads);
  return ExtractTrainingFeatures(images, options.frontend, options.second_look, 1, &executor,
                                 [](const std::string&, size_t, size_t) {});
}

TEST(ExtractTrainingFeatures, DescribesEachImageAndLooksTwiceAtSome) {
  const TemporaryFolder folder;
  const TrainingFeatures features = Extract(WriteTrainingImages(folder, 8), 0);
  ASSERT_EQ(features.images.size(), 8u);
  for (const Descriptors& image : features.images) {
    EXPECT_GT(image.Count(), 20u);
    EXPECT_EQ(image.type, DescriptorType::kSift);
  }
  EXPECT_EQ(features.looked_at, (std::vector<uint32_t>{0, 3, 6}));
  ASSERT_EQ(features.second_looks.size(), 3u);
  EXPECT_NE(features.second_looks[1].data, features.images[3].data);
}

TEST(ExtractTrainingFeatures, IsTheSameWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const auto images = WriteTrainingImages(folder, 5);
  const TrainingFeatures alone = Extract(images, 0), many = Extract(images, 3);
  for (size_t i = 0; i < 5; ++i) EXPECT_EQ(alone.images[i].data, many.images[i].data);
  EXPECT_EQ(alone.second_looks[1].data, many.second_looks[1].data);
}

TEST(ExtractTrainingFeatures, LeavesOutAndNamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  auto images = WriteTrainingImages(folder, 6);
  images[3] = folder.Write("broken.jpg", "no image");
  testing::internal::CaptureStderr();
  const TrainingFeatures features = Extract(images, 2);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("broken.jpg"), std::string::npos);
  ASSERT_EQ(features.images.size(), 5u);
  const TrainingFeatures whole = Extract(WriteTrainingImages(folder, 6), 0);
  EXPECT_EQ(features.images[3].data, whole.images[4].data);
  EXPECT_EQ(features.looked_at.size(), features.second_looks.size());
  EXPECT_THROW(Extract({images[3]}, 1), std::runtime_error);
}

TEST(ThinFeatures, TakesEvenlyFromAllImages) {
  const Descriptors image{DescriptorType::kSift, DescriptorMetric::kL2, 1, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(ThinFeatures({image, image}, 4).data, (std::vector<uint8_t>{3, 6, 3, 6}));
  EXPECT_EQ(ThinFeatures({image, image}, 100).Count(), 12u);
  EXPECT_EQ(ThinFeatures({}, 100).Count(), 0u);
}

}  // namespace
}  // namespace rovio_sfm
