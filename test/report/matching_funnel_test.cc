#include "rovio_sfm/report/matching_funnel.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(AddToFunnel, SumsTheNearestPairsOnly) {
  FrameEvent event;
  MatchingFunnel funnel;
  AddToFunnel(event, &funnel);
  EXPECT_EQ(funnel.pairs, 0u);
  event.pairs.resize(2);
  event.pairs[0].counts = {1000, 400, 390, 380, 300, 350};
  event.pairs[1].counts = {1000, 200, 190, 180, 100, 120};
  AddToFunnel(event, &funnel);
  AddToFunnel(event, &funnel);
  EXPECT_EQ(funnel.pairs, 2u);
  EXPECT_EQ(funnel.features, 2000u);
  EXPECT_EQ(funnel.ratio, 800u);
  EXPECT_EQ(funnel.percentile, 780u);
  EXPECT_EQ(funnel.one_to_one, 760u);
  EXPECT_EQ(funnel.ransac, 600u);
  EXPECT_EQ(funnel.guided, 700u);
}

}  // namespace
}  // namespace rovio_sfm
