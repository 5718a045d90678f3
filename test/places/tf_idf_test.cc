#include "rovio_sfm/places/tf_idf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "places/random_place_model.h"

namespace rovio_sfm {
namespace {

PlaceModel SmallModel() {
  PlaceModel model = RandomPlaceModel(4, 10, 1);
  model.training_bags = {{0}, {0, 1}, {0, 1, 2}};  // word 3 never
  return model;
}

TEST(TfIdf, IsTheCosineOfWeightedBinaryWords) {
  TfIdf places(SmallModel());
  places.AddPlace({0, 1});
  const double idf[4] = {std::log(4.0 / 3.0), std::log(2.0), std::log(4.0), std::log(4.0)};
  const double both = idf[1] * idf[1];
  const double expected = both / (std::hypot(idf[0], idf[1]) * std::hypot(idf[1], idf[2]));
  EXPECT_NEAR(places.Query({{1, 2}, {}, {}}).similarities[0], expected, 1e-12);
  EXPECT_NEAR(places.Query({{0, 1}, {}, {}}).score, 1.0, 1e-12);
}

TEST(TfIdf, CountsAWordOnce) {
  TfIdf places(SmallModel());
  places.AddPlace({0, 1, 1, 1});
  EXPECT_NEAR(places.Query({{0, 0, 1}, {}, {}}).score, 1.0, 1e-12);
}

TEST(TfIdf, FindsThePlaceSeenBefore) {
  const PlaceModel model = RandomPlaceModel(100, 50, 2);
  TfIdf places(model);
  for (const WordBag& bag : model.training_bags) places.AddPlace(bag);
  for (uint32_t i = 0; i < 50; ++i) {
    WordBag part = model.training_bags[i];
    part.resize(part.size() * 3 / 4);
    EXPECT_EQ(BestPlaces(places.Query({part, {}, {}}).similarities, 1).front(), i);
  }
}

TEST(TfIdf, LeavesOutExcludedPlaces) {
  TfIdf places(SmallModel());
  places.AddPlace({1});
  places.AddPlace({1, 2});
  const TfIdfResult result = places.Query({{1}, {0}, {}});
  EXPECT_EQ(result.similarities[0], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.score, result.similarities[1]);
}

TEST(TfIdf, HasNoScoreWithoutPlacesAndNoSimilarityWithoutWords) {
  TfIdf places(SmallModel());
  EXPECT_EQ(places.Query({{1}, {}, {}}).score, -std::numeric_limits<double>::infinity());
  places.AddPlace({1});
  EXPECT_EQ(places.Query({{}, {}, {}}).score, 0.0);
}

}  // namespace
}  // namespace rovio_sfm
