#include "rovio_sfm/matching/known_matches.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

const std::vector<FeatureMatch> kKnown = {{0, 2, 8.0f, 0.5f}, {3, 1, 4.0f, 0.5f}};

TEST(KnownMatches, UseFeaturesOfEachSide) {
  EXPECT_EQ(UsedFeatures(4, kKnown, &FeatureMatch::a),
            (std::vector<bool>{true, false, false, true}));
  EXPECT_EQ(UsedFeatures(3, kKnown, &FeatureMatch::b), (std::vector<bool>{false, true, true}));
  EXPECT_EQ(UsedFeatures(2, {}, &FeatureMatch::a), (std::vector<bool>{false, false}));
}

TEST(KnownMatches, HaveAMeanDistance) { EXPECT_FLOAT_EQ(MeanDistance(kKnown), 6.0f); }

}  // namespace
}  // namespace rovio_sfm
