#include "rovio_sfm/places/inverted_index.h"

#include <gtest/gtest.h>

#include "places/random_place_model.h"

namespace rovio_sfm {
namespace {

std::vector<WordWeight> RandomWeights(uint32_t num_words, Rng* rng) {
  std::vector<WordWeight> weights;
  for (uint32_t word = 0; word < num_words; word += 1 + rng->UniformInt(3)) {
    weights.push_back({word, rng->Gaussian()});
  }
  return weights;
}

// The same sums, place by place.
std::vector<double> SumsByBruteForce(const std::vector<WordBag>& bags,
                                     const std::vector<WordWeight>& weights) {
  std::vector<double> sums;
  for (const WordBag& bag : bags) {
    double sum = 0.0;
    for (const WordWeight& weight : weights) {
      if (std::binary_search(bag.begin(), bag.end(), weight.word)) sum += weight.weight;
    }
    sums.push_back(sum);
  }
  return sums;
}

TEST(InvertedIndex, SumsAsBruteForceDoesInFullAndOpenBlocks) {
  Rng rng(1);
  InvertedIndex index(30);
  std::vector<WordBag> bags;
  for (const WordBag& bag : RandomBags(600, 30, &rng)) {
    bags.push_back(bag);
    EXPECT_EQ(index.AddPlace(bag), bags.size() - 1);
    if (bags.size() % 97 != 0 && bags.size() % 256 != 0) continue;
    const std::vector<WordWeight> weights = RandomWeights(30, &rng);
    std::vector<double> sums(bags.size(), 0.0);
    index.AddWeights(weights, &sums);
    EXPECT_EQ(sums, SumsByBruteForce(bags, weights));  // bit by bit
  }
}

TEST(InvertedIndex, AddsToWhatIsThere) {
  InvertedIndex index(3);
  index.AddPlace({0, 2});
  index.AddPlace({});
  std::vector<double> sums = {10.0, 20.0};
  index.AddWeights({{0, 1.0}, {1, 2.0}, {2, 4.0}}, &sums);
  EXPECT_EQ(sums, (std::vector<double>{15.0, 20.0}));
}

TEST(InvertedIndex, AnswersWithoutPlaces) {
  std::vector<double> sums;
  InvertedIndex(5).AddWeights({{1, 1.0}}, &sums);
  EXPECT_TRUE(sums.empty());
}

TEST(InvertedIndex, HoldsAByteForAPostingInFullBlocks) {
  constexpr uint32_t kWords = 1000, kPlaces = 2560;
  Rng rng(2);
  InvertedIndex index(kWords);
  size_t num_postings = 0;
  for (const WordBag& bag : RandomBags(kPlaces, kWords, &rng)) {
    num_postings += bag.size();
    index.AddPlace(bag);
  }
  EXPECT_LT(index.NumBytes(), num_postings + kPlaces / 256 * kWords * 5 + 10000);
}

}  // namespace
}  // namespace rovio_sfm
