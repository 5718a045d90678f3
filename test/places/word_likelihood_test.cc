#include "rovio_sfm/places/word_likelihood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "places/random_place_model.h"

namespace rovio_sfm {
namespace {

ChowLiuNode BoundNode() { return {0, 0.2, 0.6, 0.1}; }

TEST(LikelihoodOfWord, IsADistributionOverTheObservation) {
  const WordLikelihood word = LikelihoodOfWord(BoundNode(), {0.3, 0.01});
  for (int parent : {0, 1}) {
    for (const auto& table : {word.log_if_seen, word.log_if_not_seen, word.log_if_average}) {
      EXPECT_NEAR(std::exp(table[0][parent]) + std::exp(table[1][parent]), 1.0, 1e-12);
    }
  }
}

TEST(LikelihoodOfWord, ExpectsAWordMoreWhereItWasSeen) {
  const WordLikelihood word = LikelihoodOfWord(BoundNode(), {0.3, 0.0});
  for (int parent : {0, 1}) {
    EXPECT_GT(word.log_if_seen[1][parent], word.log_if_average[1][parent]);
    EXPECT_GT(word.log_if_average[1][parent], word.log_if_not_seen[1][parent]);
  }
}

TEST(LikelihoodOfWord, ExpectsAWordMoreBesideItsParent) {
  const WordLikelihood word = LikelihoodOfWord(BoundNode(), {0.3, 0.0});
  EXPECT_GT(word.log_if_seen[1][1], word.log_if_seen[1][0]);
  EXPECT_GT(word.log_if_not_seen[1][1], word.log_if_not_seen[1][0]);
}

TEST(LikelihoodOfWord, GivesTheShareOfImagesForTheAveragePlaceIfTheParentSaysNothing) {
  const ChowLiuNode alone{kNoParent, 0.2, 0.2, 0.2};
  EXPECT_NEAR(std::exp(LikelihoodOfWord(alone, {0.3, 0.02}).log_if_average[1][0]), 0.2, 1e-12);
}

TEST(LikelihoodOfWord, StaysFiniteForExtremeWords) {
  for (const double p_z : {1e-6, 1.0 - 1e-6}) {
    const WordLikelihood word = LikelihoodOfWord({0, p_z, p_z, p_z}, {0.01, 0.0});
    for (const auto& table : {word.log_if_seen, word.log_if_not_seen, word.log_if_average}) {
      for (int z : {0, 1}) EXPECT_TRUE(std::isfinite(table[z][0]) && std::isfinite(table[z][1]));
    }
  }
}

// log p(Z | place) word by word, without the table's short cuts.
double LogLikelihoodByBruteForce(const PlaceModel& model, const WordBag& observation,
                                 const WordBag& place) {
  const auto has = [](const WordBag& bag, uint32_t word) {
    return std::binary_search(bag.begin(), bag.end(), word);
  };
  double sum = 0.0;
  for (uint32_t word = 0; word < model.tree.size(); ++word) {
    const ChowLiuNode& node = model.tree[word];
    const bool parent_z = node.parent != kNoParent && has(observation, node.parent);
    const WordLikelihood likelihood = LikelihoodOfWord(node, model.detector);
    const bool z = has(observation, word);
    sum += has(place, word) ? likelihood.log_if_seen[z][parent_z]
                            : likelihood.log_if_not_seen[z][parent_z];
  }
  return sum;
}

TEST(LikelihoodTable, SplitsTheLikelihoodIntoOffsetConstantAndWeights) {
  const PlaceModel model = RandomPlaceModel(60, 80, 1);
  const LikelihoodTable table(model.tree, model.detector);
  for (size_t i = 0; i + 1 < model.training_bags.size(); ++i) {
    const WordBag &observation = model.training_bags[i], &place = model.training_bags[i + 1];
    const ObservationWeights weights = table.WeightsOf(observation);
    double sum = weights.offset + table.ConstantOfBag(place);
    for (const WordWeight& weight : weights.weights) {
      if (std::binary_search(place.begin(), place.end(), weight.word)) sum += weight.weight;
    }
    EXPECT_NEAR(sum, LogLikelihoodByBruteForce(model, observation, place), 1e-10);
  }
}

TEST(LikelihoodTable, TouchesOnlyWordsOfTheObservationAndTheirChildren) {
  const PlaceModel model = RandomPlaceModel(60, 80, 2);
  const LikelihoodTable table(model.tree, model.detector);
  EXPECT_TRUE(table.WeightsOf({}).weights.empty());
  const WordBag observation = {3, 17};
  uint32_t last = 0;
  for (const WordWeight& weight : table.WeightsOf(observation).weights) {
    const uint32_t parent = model.tree[weight.word].parent;
    EXPECT_TRUE(weight.word == 3 || weight.word == 17 || parent == 3 || parent == 17);
    EXPECT_GE(weight.word, last);
    last = weight.word;
  }
}

}  // namespace
}  // namespace rovio_sfm
