#include "rovio_sfm/ros/image_gate.h"

#include <gtest/gtest.h>

#include "rovio_sfm/ros/conversions.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kSecondNs = 1000000000;

class ImageGateTest : public testing::Test {
 protected:
  ImageGateTest() : sensors_(Sensors(), &transforms_), gate_(GateOptions(), &sensors_) {
    std::string error;
    const Camera camera{500.0, 500.0, 32.0, 24.0, 0, 0, 0, 0, 0, 64, 48};
    sensors_.AddCameraInfo(ToCameraInfo(camera, 0, ""), &error);
  }

  static SensorOptions Sensors() {
    SensorOptions options;
    options.base_frame = "base_link";
    return options;
  }

  static WaitingImage Image(int64_t second) {
    WaitingImage image;
    image.header.stamp = ToTime(second * kSecondNs);
    image.header.frame_id = "camera_optical";
    image.name = std::to_string(second);
    return image;
  }

  void AddOdometry(int64_t second) {
    std::string error;
    sensors_.AddOdometry(ToOdometry({}, second * kSecondNs, "", ""), &error);
  }

  void AddHead() {
    geometry_msgs::TransformStamped head;
    head.header.frame_id = "base_link";
    head.child_frame_id = "camera_optical";
    head.transform = ToTransform(Rigid3());
    transforms_.setTransform(head, "test", true);
  }

  tf2::BufferCore transforms_;
  RobotSensors sensors_;
  ImageGate gate_;
};

TEST_F(ImageGateTest, CompleteImageGoesAtOnce) {
  AddHead();
  AddOdometry(100);
  gate_.Add(Image(100), 0.0);
  const auto event = gate_.Take(0.0);
  ASSERT_TRUE(event);
  EXPECT_TRUE(event->odometry);
  EXPECT_FALSE(gate_.Take(0.0));
}

TEST_F(ImageGateTest, ImageWaitsForOdometryUpToItsStamp) {
  AddHead();
  AddOdometry(99);
  gate_.Add(Image(100), 0.0);
  EXPECT_FALSE(gate_.Take(0.1));
  AddOdometry(101);
  EXPECT_TRUE(gate_.Take(0.1));
}

TEST_F(ImageGateTest, ImageWaitsNotForEver) {
  AddHead();
  AddOdometry(99);
  gate_.Add(Image(100), 5.0);
  gate_.Add(Image(101), 7.0);
  EXPECT_TRUE(gate_.Take(7.0));
  EXPECT_FALSE(gate_.Take(7.2));
  EXPECT_TRUE(gate_.Take(7.31));
}

TEST_F(ImageGateTest, WithoutOdometryAndHeadOnlyTheStartWaits) {
  gate_.Add(Image(100), 0.0);
  EXPECT_FALSE(gate_.Take(0.9));
  EXPECT_TRUE(gate_.Take(1.0));
  gate_.Add(Image(101), 1.1);
  EXPECT_TRUE(gate_.Take(1.1));
}

TEST_F(ImageGateTest, OldestIsDroppedWhenFull) {
  for (int64_t i = 0; i <= static_cast<int64_t>(ImageGate::kCapacity); ++i) {
    gate_.Add(Image(100 + i), 0.0);
  }
  EXPECT_EQ(gate_.NumDropped(), 1u);
  const auto event = gate_.Take(10.0);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->name, "101");
}

}  // namespace
}  // namespace rovio_sfm
