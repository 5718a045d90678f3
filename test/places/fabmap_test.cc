#include "rovio_sfm/places/fabmap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "places/random_place_model.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr double kMinusInfinity = -std::numeric_limits<double>::infinity();
constexpr uint32_t kWords = 200;

double SumOf(const FabmapResult& result) {
  return std::accumulate(result.posteriors.begin(), result.posteriors.end(),
                         result.new_place_posterior);
}

// Another look at a place: some words lost, some new.
WordBag LookAgain(const WordBag& place, Rng* rng) {
  WordBag words;
  for (const uint32_t word : place) {
    if (rng->Uniform() < 0.75) words.push_back(word);
  }
  for (int i = 0; i < 10; ++i) words.push_back(rng->UniformInt(kWords));
  return BagOfWords(words);
}

class FabmapTest : public testing::Test {
 protected:
  FabmapTest() : model_(SharedRandomPlaceModel(kWords, 100, 1)), rng_(2) {
    places_ = RandomBags(300, kWords, &rng_);
  }
  Fabmap FilledFabmap(const FabmapOptions& options) {
    Fabmap fabmap(model_, options);
    for (const WordBag& place : places_) fabmap.AddPlace(place);
    return fabmap;
  }

  std::shared_ptr<const PlaceModel> model_;
  Rng rng_;
  std::vector<WordBag> places_;
};

TEST_F(FabmapTest, FindsThePlaceSeenBefore) {
  const Fabmap fabmap = FilledFabmap({});
  for (uint32_t place = 0; place < 300; place += 10) {
    const FabmapResult result = fabmap.Query({LookAgain(places_[place], &rng_), {}, {}});
    EXPECT_EQ(BestPlaces(result.log_likelihoods, 1), (std::vector<uint32_t>{place}));
    EXPECT_GT(result.score, 0.0);
  }
}

TEST_F(FabmapTest, ScoresPlacesNeverSeenBelowPlacesSeen) {
  const Fabmap fabmap = FilledFabmap({NewPlaceModel::kSampled});
  double greatest_new = kMinusInfinity, least_seen = -kMinusInfinity;
  const std::vector<WordBag> elsewhere = RandomBags(20, kWords, &rng_);
  for (uint32_t i = 0; i < 20; ++i) {
    const WordBag again = LookAgain(places_[10 * i], &rng_);
    greatest_new = std::max(greatest_new, fabmap.Query({elsewhere[i], {}, {}}).score);
    least_seen = std::min(least_seen, fabmap.Query({again, {}, {}}).score);
  }
  EXPECT_LT(greatest_new, least_seen);
}

TEST_F(FabmapTest, PosteriorsAddUpToOne) {
  const Fabmap fabmap = FilledFabmap({});
  EXPECT_NEAR(SumOf(fabmap.Query({places_[5], {}, {}})), 1.0, 1e-12);
  EXPECT_NEAR(SumOf(fabmap.Query({{}, {}, {}})), 1.0, 1e-12);
}

TEST_F(FabmapTest, KnowsOnlyTheNewPlaceAtFirst) {
  const FabmapResult result = Fabmap(model_, {}).Query({places_[0], {}, {}});
  EXPECT_TRUE(result.posteriors.empty());
  EXPECT_EQ(result.new_place_posterior, 1.0);
  EXPECT_EQ(result.score, kMinusInfinity);
}

TEST_F(FabmapTest, NeverAnswersWithAnExcludedPlace) {
  const Fabmap fabmap = FilledFabmap({});
  const FabmapResult result = fabmap.Query({places_[7], {7, 299}, {}});
  EXPECT_EQ(result.log_likelihoods[7], kMinusInfinity);
  EXPECT_EQ(result.posteriors[7], 0.0);
  EXPECT_EQ(result.posteriors[299], 0.0);
  EXPECT_NEAR(SumOf(result), 1.0, 1e-12);
  EXPECT_LT(result.score, fabmap.Query({places_[7], {}, {}}).score);
}

TEST_F(FabmapTest, ExcludingAllPlacesLeavesTheNewOne) {
  Fabmap fabmap(model_, {});
  fabmap.AddPlace(places_[0]);
  const FabmapResult result = fabmap.Query({places_[0], {0}, {}});
  EXPECT_EQ(result.new_place_posterior, 1.0);
  EXPECT_EQ(result.score, kMinusInfinity);
}

TEST_F(FabmapTest, TreatsAnExcludedPlaceAsIfItWereNotThere) {
  Fabmap with(model_, {}), without(model_, {});
  for (const uint32_t place : {0u, 1u}) {
    with.AddPlace(places_[place]);
    without.AddPlace(places_[place]);
  }
  with.AddPlace(places_[2]);
  const FabmapResult a = with.Query({places_[1], {2}, {}});
  const FabmapResult b = without.Query({places_[1], {}, {}});
  EXPECT_EQ(a.score, b.score);
  EXPECT_EQ(a.posteriors[1], b.posteriors[1]);
  EXPECT_EQ(a.new_place_posterior, b.new_place_posterior);
}

TEST_F(FabmapTest, FollowsTheMotionPrior) {
  Fabmap fabmap(model_, {});
  fabmap.AddPlace(places_[0]);
  fabmap.AddPlace(places_[0]);  // looks the same
  const FabmapResult result = fabmap.Query({places_[0], {}, {1.0, 3.0}});
  EXPECT_NEAR(result.posteriors[1] / result.posteriors[0], 3.0, 1e-9);
  const FabmapResult even = fabmap.Query({places_[0], {}, {}});
  EXPECT_EQ(even.posteriors[0], even.posteriors[1]);
  EXPECT_EQ(even.score, result.score);  // the score knows no prior
}

TEST_F(FabmapTest, IgnoresOrderAndRepetitionOfWords) {
  const Fabmap fabmap = FilledFabmap({});
  const WordBag bag = places_[3];
  std::vector<uint32_t> mixed(bag.rbegin(), bag.rend());
  mixed.insert(mixed.end(), bag.begin(), bag.end());
  EXPECT_EQ(fabmap.Query({bag, {}, {}}).log_likelihoods,
            fabmap.Query({mixed, {}, {}}).log_likelihoods);
}

TEST_F(FabmapTest, BelievesInANewPlaceAsTheOptionSays) {
  Fabmap doubtful(model_, {NewPlaceModel::kSampled, 0.99}),
      trusting(model_, {NewPlaceModel::kSampled, 0.5});
  doubtful.AddPlace(places_[0]);
  trusting.AddPlace(places_[0]);
  EXPECT_GT(doubtful.Query({{}, {}, {}}).new_place_posterior,
            trusting.Query({{}, {}, {}}).new_place_posterior);
}

TEST_F(FabmapTest, SamplingMeetsTheTrainingPlacesThemselves) {
  const Fabmap sampled(model_, {NewPlaceModel::kSampled}),
      mean(model_, {NewPlaceModel::kMeanField});
  const PlaceQuery query{model_->training_bags[4], {}, {}};
  EXPECT_GT(sampled.Query(query).new_place_log_likelihood,
            mean.Query(query).new_place_log_likelihood);
}

TEST_F(FabmapTest, UsesMeanFieldWithoutTrainingPlaces) {
  PlaceModel bare = *model_;
  bare.training_bags.clear();
  const auto shared = std::make_shared<const PlaceModel>(bare);
  const PlaceQuery query{places_[4], {}, {}};
  EXPECT_EQ(Fabmap(shared, {NewPlaceModel::kSampled}).Query(query).new_place_log_likelihood,
            Fabmap(shared, {NewPlaceModel::kMeanField}).Query(query).new_place_log_likelihood);
}

TEST(FabmapOptions, NamesWhatDoesNotFit) {
  std::string error;
  EXPECT_TRUE(IsValid(FabmapOptions{}, &error));
  EXPECT_FALSE((IsValid(FabmapOptions{NewPlaceModel::kSampled, 1.0}, &error)));
  EXPECT_EQ(error, "new_place_prior = 1: expected 0.001 to 0.999");
}

}  // namespace
}  // namespace rovio_sfm
