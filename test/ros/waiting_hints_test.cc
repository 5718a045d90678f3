#include "rovio_sfm/ros/waiting_hints.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(WaitingHints, NameWhatIsAwaitedAndWhatThereIs) {
  const AwaitedTopic images = {"images", "/rovio1/image_raw", {"sensor_msgs/Image"}};
  EXPECT_EQ(Describe(images, {"/a", "/b"}),
            "no images on /rovio1/image_raw yet; topics of that type: /a, /b");
  EXPECT_EQ(Describe(images, {}), "no images on /rovio1/image_raw yet; topics of that type: none");
}

TEST(WaitingHints, FramesOfEveryRobotAreAwaited) {
  const std::vector<AwaitedTopic> awaited = AwaitedFrames({"rovio1", "rovio2"});
  ASSERT_EQ(awaited.size(), 2u);
  EXPECT_EQ(Describe(awaited[1], {}), "no frames on /rovio2/frames yet; topics of that type: none");
}

}  // namespace
}  // namespace rovio_sfm
