#include "rovio_sfm/places/measure_detector.h"

#include <gtest/gtest.h>

#include "rovio_sfm/places/detector_model.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

TEST(MeasureDetector, FindsTheDetectorThatMadeThePairs) {
  constexpr uint32_t kWords = 2000;
  const DetectorOptions detector{0.3, 0.0};
  Rng rng(1);
  ChowLiuTree tree(kWords);
  for (ChowLiuNode& node : tree) node.p_z = rng.Uniform(0.01, 0.4);
  std::vector<BagPair> pairs(50);
  for (BagPair& pair : pairs) {
    for (uint32_t word = 0; word < kWords; ++word) {
      const WordDetector of_word = DetectorOfWord(detector, tree[word].p_z);
      if (rng.Uniform() >= of_word.p_e) continue;
      if (rng.Uniform() < of_word.p_z_given_e) pair.first.push_back(word);
      if (rng.Uniform() < of_word.p_z_given_e) pair.second.push_back(word);
    }
  }
  const DetectorReport report = MeasureDetector(pairs, tree);
  EXPECT_NEAR(report.p_z_given_e, 0.3, 0.02);
  EXPECT_GT(report.seen_again, report.p_z_given_e);
}

TEST(MeasureDetector, CountsTheShareSeenAgain) {
  ChowLiuTree tree(4);
  for (ChowLiuNode& node : tree) node.p_z = 0.5;
  const DetectorReport report = MeasureDetector({{{0, 1, 2, 3}, {0, 1, 3}}}, tree);
  EXPECT_EQ(report.num_words, 4u);
  EXPECT_EQ(report.seen_again, 0.75);
  EXPECT_EQ(report.p_z_given_e, 0.5);
}

TEST(MeasureDetector, IsNeverNegativeAndIsZeroWithoutWords) {
  ChowLiuTree tree(1);
  EXPECT_EQ(MeasureDetector({{{0}, {}}}, tree).p_z_given_e, 0.0);
  EXPECT_EQ(MeasureDetector({}, tree).num_words, 0u);
}

}  // namespace
}  // namespace rovio_sfm
