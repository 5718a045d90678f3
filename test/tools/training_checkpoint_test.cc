#include "rovio_sfm/tools/training_checkpoint.h"

#include <fstream>

#include "tools/training_folder.h"

namespace rovio_sfm {
namespace {

Descriptors Rows(std::vector<uint8_t> data) {
  return {DescriptorType::kSift, DescriptorMetric::kL2, 2, std::move(data)};
}

TEST(TrainingCheckpoint, KeepsFeaturesAndWordsUnderTheirKey) {
  const TemporaryFolder folder;
  const TrainingCheckpoint checkpoint(folder.Path() / "work");
  EXPECT_FALSE(checkpoint.LoadFeatures("a").has_value());
  checkpoint.SaveFeatures("a", {{Rows({1, 2, 3, 4}), Rows({})}, {1}, {Rows({5, 6})}});
  checkpoint.SaveWords("b", {7, true, Rows({9, 8}), 2.5});
  const auto features = TrainingCheckpoint(folder.Path() / "work").LoadFeatures("a");
  ASSERT_TRUE(features.has_value());
  EXPECT_EQ(features->images[0].data, (std::vector<uint8_t>{1, 2, 3, 4}));
  EXPECT_EQ(features->images[1].Count(), 0u);
  EXPECT_EQ(features->looked_at, (std::vector<uint32_t>{1}));
  EXPECT_EQ(features->second_looks[0].data, (std::vector<uint8_t>{5, 6}));
  const auto words = checkpoint.LoadWords("b");
  ASSERT_TRUE(words.has_value());
  EXPECT_EQ(words->num_iterations, 7u);
  EXPECT_TRUE(words->converged);
  EXPECT_EQ(words->words.data, (std::vector<uint8_t>{9, 8}));
  EXPECT_EQ(words->mean_squared_distance, 2.5);
}

TEST(TrainingCheckpoint, TakesUpNothingMadeFromSomethingElse) {
  const TemporaryFolder folder;
  const TrainingCheckpoint checkpoint(folder.Path());
  checkpoint.SaveWords("5000 words", {7, true, Rows({9, 8}), 2.5});
  EXPECT_FALSE(checkpoint.LoadWords("3000 words").has_value());
}

TEST(TrainingCheckpoint, TakesUpNothingBroken) {
  const TemporaryFolder folder;
  const TrainingCheckpoint checkpoint(folder.Path());
  checkpoint.SaveWords("a", {7, true, Rows({9, 8}), 2.5});
  const auto size = std::filesystem::file_size(folder.Path() / "words.bin");
  for (uintmax_t shorter = 0; shorter < size; ++shorter) {
    std::filesystem::resize_file(folder.Path() / "words.bin", size - 1 - shorter);
    EXPECT_FALSE(checkpoint.LoadWords("a").has_value()) << shorter;
  }
  checkpoint.SaveWords("a", {7, true, Rows({9, 8}), 2.5});
  std::ofstream(folder.Path() / "words.bin", std::ios::app) << "x";
  EXPECT_FALSE(checkpoint.LoadWords("a").has_value());
}

}  // namespace
}  // namespace rovio_sfm
