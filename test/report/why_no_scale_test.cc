#include "rovio_sfm/report/why_no_scale.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(CountMotion, CountsWhatFramesBring) {
  MotionCounts counts;
  FrameEvent event;
  CountMotion(event, &counts);
  event.base_from_camera = Rigid3{};
  CountMotion(event, &counts);
  event.odometry = OdometrySample{};
  CountMotion(event, &counts);
  EXPECT_EQ(counts.frames, 3u);
  EXPECT_EQ(counts.with_odometry, 1u);
  EXPECT_EQ(counts.with_head, 2u);
}

TEST(WhyNoScale, NamesTheFirstThingThatIsMissing) {
  EXPECT_NE(WhyNoScale({}).find("no frame"), std::string::npos);
  EXPECT_NE(WhyNoScale({5, 0, 5}).find("no odometry"), std::string::npos);
  EXPECT_NE(WhyNoScale({5, 5, 0}).find("no tf"), std::string::npos);
  EXPECT_NE(WhyNoScale({5, 5, 5}).find("moved too little"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
