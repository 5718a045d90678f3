#include "rovio_sfm/places/motion_prior.h"

#include <gtest/gtest.h>

#include <numeric>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kFirst = MotionPrior::kNoPlace;

FabmapResult ResultWith(std::vector<double> posteriors) {
  FabmapResult result;
  result.new_place_posterior = 1.0 - std::accumulate(posteriors.begin(), posteriors.end(), 0.0);
  result.posteriors = std::move(posteriors);
  return result;
}

TEST(MotionPrior, MovesMassToTheNeighboursOfTheSameDrive) {
  MotionPrior prior({2.0 / 3.0, 0.001});
  for (const uint32_t previous : {kFirst, kFirst, 0u, 1u, 2u})
    prior.AddPlace(previous);  // 0-2-4, 1-3
  const std::vector<double> weights = prior.Predict(ResultWith({0.0, 0.0, 1.0, 0.0, 0.0}));
  for (const uint32_t place : {0u, 2u, 4u}) EXPECT_NEAR(weights[place], 1.0 / 3.0, 0.001);
  for (const uint32_t place : {1u, 3u}) EXPECT_NEAR(weights[place], 0.0, 0.001);
}

TEST(MotionPrior, AddsUpToOneAndRulesOutNoPlace) {
  MotionPrior prior({});
  for (const uint32_t previous : {kFirst, 0u, 1u, kFirst}) prior.AddPlace(previous);
  for (const auto& last :
       {ResultWith({0.3, 0.2}), ResultWith({0.0, 0.0, 0.0, 1.0}), ResultWith({})}) {
    const std::vector<double> weights = prior.Predict(last);
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
    for (const double weight : weights) EXPECT_GT(weight, 0.0);
  }
}

TEST(MotionPrior, IsEvenAfterANewPlace) {
  MotionPrior prior({});
  for (const uint32_t previous : {kFirst, 0u}) prior.AddPlace(previous);
  EXPECT_EQ(prior.Predict(ResultWith({})), (std::vector<double>{0.5, 0.5}));
}

TEST(MotionPrior, IsEmptyWithoutPlaces) {
  EXPECT_TRUE(MotionPrior({}).Predict(ResultWith({})).empty());
}

TEST(MotionPriorOptions, NamesWhatDoesNotFit) {
  std::string error;
  EXPECT_TRUE(IsValid(MotionPriorOptions{}, &error));
  EXPECT_FALSE((IsValid(MotionPriorOptions{0.5, 0.0}, &error)));
  EXPECT_EQ(error, "uniform_share = 0: expected 0.001 to 1");
}

}  // namespace
}  // namespace rovio_sfm
