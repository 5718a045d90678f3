#include "rovio_sfm/tracks/filter_f1.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(PassesFilterF1, AcceptsTracksWithoutCommonFrame) {
  EXPECT_TRUE(PassesFilterF1({{1, 0, {0, 0}}, {3, 0, {0, 0}}}, {{2, 5, {90, 90}}}, 1.5));
  EXPECT_TRUE(PassesFilterF1({}, {}, 1.5));
  EXPECT_TRUE(PassesFilterF1({}, {{1, 0, {0, 0}}}, 1.5));
}

TEST(PassesFilterF1, RefusesTwoFeaturesFarApartInOneFrame) {
  EXPECT_FALSE(PassesFilterF1({{1, 0, {0, 0}}, {3, 7, {10, 10}}},
                              {{2, 5, {90, 90}}, {3, 8, {14, 10}}}, 1.5));
}

TEST(PassesFilterF1, AcceptsTheSameAndNearbyFeatures) {
  EXPECT_TRUE(PassesFilterF1({{3, 7, {10, 10}}}, {{3, 7, {10, 10}}}, 0.0));
  EXPECT_TRUE(PassesFilterF1({{3, 7, {10, 10}}}, {{3, 8, {11, 10}}}, 1.5));
}

TEST(PassesFilterF1, ComparesEveryFeatureOfACommonFrame) {
  EXPECT_FALSE(PassesFilterF1({{3, 7, {10, 10}}, {3, 9, {11, 10}}},
                              {{3, 8, {10, 11}}, {3, 4, {12.4f, 10}}}, 2.0));
}

}  // namespace
}  // namespace rovio_sfm
