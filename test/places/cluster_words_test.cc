#include "rovio_sfm/places/cluster_words.h"

#include <gtest/gtest.h>

#include <set>

#include "rovio_sfm/places/vocabulary.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kLength = 16;

Descriptors Rows(std::vector<uint8_t> data, uint32_t length) {
  return {DescriptorType::kSift, DescriptorMetric::kL2, length, std::move(data)};
}

// Clouds of features around `num_centers` points far from each other.
Descriptors Clouds(size_t num_features, uint32_t num_centers, uint64_t seed) {
  Rng rng(seed);
  std::vector<uint8_t> centers, data;
  for (uint32_t i = 0; i < num_centers * kLength; ++i) {
    centers.push_back(static_cast<uint8_t>(20 + rng.UniformInt(200)));
  }
  for (size_t i = 0; i < num_features; ++i) {
    const uint32_t center = rng.UniformInt(num_centers);
    for (uint32_t k = 0; k < kLength; ++k) {
      data.push_back(static_cast<uint8_t>(centers[center * kLength + k] + rng.UniformInt(9) - 4));
    }
  }
  return Rows(data, kLength);
}

ClusterOptions OptionsFor(int num_words) {
  ClusterOptions options;
  options.num_words = num_words;
  return options;
}

ClusterState Cluster(const Descriptors& features, const ClusterOptions& options, uint64_t seed,
                     int num_threads) {
  Rng rng(seed);
  Executor executor(num_threads);
  return ClusterWords(features, options, {}, &rng, &executor, [](const ClusterState&) {});
}

TEST(ClusterWords, FindsTheMiddlesOfClouds) {
  const Descriptors features = Clouds(2000, 10, 1);
  const ClusterState state = Cluster(features, OptionsFor(15), 1, 0);
  EXPECT_TRUE(state.converged);
  EXPECT_EQ(state.words.Count(), 15u);
  EXPECT_LT(state.mean_squared_distance, kLength * 8.0);  // variance of -4 … 4 is 20/3
}

TEST(ClusterWords, GivesTheSameBytesWithAnyNumberOfThreads) {
  const Descriptors features = Clouds(10000, 40, 2);
  const Descriptors words = Cluster(features, OptionsFor(60), 5, 0).words;
  EXPECT_EQ(Cluster(features, OptionsFor(60), 5, 1).words.data, words.data);
  EXPECT_EQ(Cluster(features, OptionsFor(60), 5, 3).words.data, words.data);
}

TEST(ClusterWords, DependsOnTheSeedOnly) {
  const Descriptors features = Clouds(3000, 40, 3);
  EXPECT_EQ(Cluster(features, OptionsFor(20), 5, 0).words.data,
            Cluster(features, OptionsFor(20), 5, 0).words.data);
  EXPECT_NE(Cluster(features, OptionsFor(20), 5, 0).words.data,
            Cluster(features, OptionsFor(20), 6, 0).words.data);
}

TEST(ClusterWords, GoesOnWhereItStopped) {
  const Descriptors features = Clouds(4000, 60, 4);
  const ClusterOptions options = OptionsFor(30);
  std::vector<ClusterState> states;
  Rng rng(7);
  Executor executor(0);
  const ClusterState whole =
      ClusterWords(features, options, {}, &rng, &executor,
                   [&](const ClusterState& state) { states.push_back(state); });
  ASSERT_GT(states.size(), 3u);
  for (const ClusterState& stopped : states) {
    Rng other(99);
    const ClusterState resumed =
        ClusterWords(features, options, stopped, &other, &executor, [](const ClusterState&) {});
    EXPECT_EQ(resumed.words.data, whole.words.data);
    EXPECT_EQ(resumed.num_iterations, whole.num_iterations);
  }
}

TEST(ClusterWords, ComesNearerWithEachIteration) {
  const Descriptors features = Clouds(4000, 60, 5);
  double last = 0.0;
  Rng rng(8);
  Executor executor(0);
  ClusterWords(features, OptionsFor(30), {}, &rng, &executor, [&](const ClusterState& state) {
    if (state.num_iterations > 1) {
      EXPECT_LE(state.mean_squared_distance, last);
    }
    last = state.mean_squared_distance;
  });
}

TEST(ClusterWords, StopsAfterTheIterationsAllowed) {
  ClusterOptions options = OptionsFor(30);
  options.max_iterations = 2;
  options.min_gain = 0.0;
  EXPECT_EQ(Cluster(Clouds(4000, 60, 6), options, 1, 0).num_iterations, 2u);
}

TEST(SeedWords, DrawsFarFeaturesRatherThanNearOnes) {
  std::vector<uint8_t> data(1000, 50);  // many equal features of length 1 …
  for (const uint8_t far : std::vector<uint8_t>{0, 100, 150, 200}) data.push_back(far);
  Rng rng(1);
  const ClusterState state = SeedWords(Rows(data, 1), OptionsFor(5), &rng);
  EXPECT_EQ(std::set<uint8_t>(state.words.data.begin(), state.words.data.end()),
            (std::set<uint8_t>{0, 50, 100, 150, 200}));
}

TEST(SeedWords, RepeatsWordsWhereFeaturesAreTooFew) {
  Rng rng(1);
  EXPECT_EQ(SeedWords(Rows({10, 20, 20}, 1), OptionsFor(8), &rng).words.Count(), 8u);
}

TEST(ImproveWords, GivesAWordWithoutFeaturesTheFarthestOne) {
  ClusterState state;
  state.words = Rows({10, 10, 90}, 1);  // the second never wins
  Executor executor(0);
  const ClusterState next = ImproveWords(Rows({10, 12, 90, 250}, 1), state, {}, &executor);
  EXPECT_EQ(next.words.data, (std::vector<uint8_t>{11, 250, 170}));
}

TEST(ClusterOptions, NamesWhatDoesNotFit) {
  std::string error;
  EXPECT_TRUE(IsValid(ClusterOptions{}, &error));
  EXPECT_FALSE(IsValid(OptionsFor(1), &error));
  EXPECT_EQ(error, "num_words = 1: expected 2 to 65536");
}

}  // namespace
}  // namespace rovio_sfm
