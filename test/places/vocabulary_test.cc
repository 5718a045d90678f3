#include "rovio_sfm/places/vocabulary.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

Descriptors RandomDescriptors(size_t count, uint64_t seed) {
  Rng rng(seed);
  Descriptors descriptors;
  descriptors.type = DescriptorType::kSift;
  descriptors.length = 128;
  for (size_t i = 0; i < count * 128; ++i) {
    descriptors.data.push_back(static_cast<uint8_t>(rng.UniformInt(200)));
  }
  return descriptors;
}

uint32_t NearestByBruteForce(const Descriptors& words, const uint8_t* descriptor) {
  uint32_t best = 0;
  int64_t best_distance = -1;
  for (uint32_t word = 0; word < words.Count(); ++word) {
    int64_t distance = 0;
    for (uint32_t k = 0; k < words.length; ++k) {
      const int64_t difference = int64_t{words.Row(word)[k]} - descriptor[k];
      distance += difference * difference;
    }
    if (best_distance < 0 || distance < best_distance) {
      best = word;
      best_distance = distance;
    }
  }
  return best;
}

TEST(Vocabulary, FindsTheNearestWordExactly) {
  const Descriptors words = RandomDescriptors(50, 1), features = RandomDescriptors(300, 2);
  const std::vector<uint32_t> found = Vocabulary(words).Quantize(features);
  ASSERT_EQ(found.size(), 300u);
  for (size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i], NearestByBruteForce(words, features.Row(i)));
  }
}

// Few words are near such descriptors; most are ruled out by a part of the coordinates.
TEST(Vocabulary, FindsTheNearestWordExactlyWhereDescriptorsGather) {
  const Descriptors words = RandomDescriptors(200, 10);
  Descriptors features = words;
  Rng rng(11);
  for (uint8_t& byte : features.data) {
    byte = static_cast<uint8_t>(byte / 2 + rng.UniformInt(128));
  }
  const std::vector<uint32_t> found = Vocabulary(words).Quantize(features);
  for (size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i], NearestByBruteForce(words, features.Row(i)));
  }
}

TEST(Vocabulary, GivesEachWordToItself) {
  const Descriptors words = RandomDescriptors(40, 3);
  const std::vector<uint32_t> found = Vocabulary(words).Quantize(words);
  for (uint32_t i = 0; i < 40; ++i) EXPECT_EQ(found[i], i);
}

TEST(Vocabulary, TakesTheFirstOfEquallyNearWords) {
  Descriptors words = RandomDescriptors(10, 4);
  words.data.insert(words.data.end(), words.data.begin(), words.data.end());  // each twice
  for (const uint32_t word : Vocabulary(words).Quantize(RandomDescriptors(100, 5))) {
    EXPECT_LT(word, 10u);
  }
}

TEST(Vocabulary, GivesNoWordsForNoFeatures) {
  EXPECT_TRUE(Vocabulary(RandomDescriptors(5, 6)).Quantize(RandomDescriptors(0, 7)).empty());
}

TEST(Vocabulary, RefusesOtherDescriptorsAndNamesBoth) {
  const Vocabulary vocabulary(RandomDescriptors(5, 8));
  Descriptors orb = RandomDescriptors(5, 9);
  orb.type = DescriptorType::kOrb;
  std::string reason;
  EXPECT_FALSE(vocabulary.Accepts(orb, &reason));
  EXPECT_EQ(reason,
            "descriptors are of type 2 of 128 bytes, the vocabulary's words of type 1 of 128 "
            "bytes");
  Descriptors longer = RandomDescriptors(5, 9);
  longer.length = 64;
  EXPECT_FALSE(vocabulary.Accepts(longer, nullptr));
}

TEST(FindNearestCenters, KnowsTheSquaredDistances) {
  const FloatRows centers = ToFloatRows({0, 0, 10, 0}, 2), points = ToFloatRows({8, 1, 1, 2}, 2);
  const std::vector<NearestCenter> nearest = FindNearestCenters(centers, points);
  EXPECT_EQ(nearest[0].index, 1u);
  EXPECT_EQ(nearest[0].squared_distance, 5.0f);
  EXPECT_EQ(nearest[1].index, 0u);
  EXPECT_EQ(nearest[1].squared_distance, 5.0f);
}

}  // namespace
}  // namespace rovio_sfm
