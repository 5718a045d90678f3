#include "rovio_sfm/ros/robot_sensors.h"

#include <gtest/gtest.h>

#include "rovio_sfm/ros/conversions.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kSecondNs = 1000000000;

class RobotSensorsTest : public testing::Test {
 protected:
  RobotSensorsTest() {
    options_.base_frame = "base_link";
    image_.stamp_ns = 100 * kSecondNs;
    image_.camera_frame = "camera_optical";
    image_.name = "7";
  }

  // Known at every stamp, or at one alone.
  void AddHead(bool is_static = true, int64_t stamp_ns = 0) {
    geometry_msgs::TransformStamped head;
    head.header.stamp = ToTime(stamp_ns);
    head.header.frame_id = "base_link";
    head.child_frame_id = "camera_optical";
    head.transform = ToTransform({Eigen::Quaterniond::Identity(), {0.1, 0.2, 0.3}});
    transforms_.setTransform(head, "test", is_static);
  }

  RobotSensors Sensors() const {
    RobotSensors sensors(options_, &transforms_);
    std::string error;
    const Camera camera{500.0, 500.0, 32.0, 24.0, 0, 0, 0, 0, 0, 64, 48};
    EXPECT_TRUE(sensors.AddCameraInfo(ToCameraInfo(camera, 0, ""), &error));
    for (const int64_t tenths : {998, 999, 1000}) {
      const OdometrySample sample{static_cast<double>(tenths), 0.0, 0.0, {}};
      EXPECT_TRUE(sensors.AddOdometry(ToOdometry(sample, tenths * kSecondNs / 10, "", ""), &error));
    }
    return sensors;
  }

  SensorOptions options_;
  tf2::BufferCore transforms_;
  RawImage image_;
};

TEST_F(RobotSensorsTest, EventHoldsOdometryAndHeadAtTheStamp) {
  AddHead();
  const ImageEvent event = Sensors().MakeEvent(image_);
  EXPECT_EQ(event.name, "7");
  EXPECT_EQ(event.camera_frame, "camera_optical");
  ASSERT_TRUE(event.odometry && event.base_from_camera);
  EXPECT_DOUBLE_EQ(event.odometry->x_m, 1000.0);
  EXPECT_DOUBLE_EQ(event.base_from_camera->translation.y(), 0.2);
}

TEST_F(RobotSensorsTest, HeadOfAnotherStampIsThereButNotKnown) {
  AddHead(false, image_.stamp_ns - kSecondNs);
  EXPECT_TRUE(Sensors().HasHead(image_));
  EXPECT_FALSE(Sensors().KnowsHead(image_));
  EXPECT_FALSE(Sensors().MakeEvent(image_).base_from_camera);
}

TEST_F(RobotSensorsTest, UnknownHeadStaysUnknown) {
  EXPECT_FALSE(Sensors().HasHead(image_));
  EXPECT_FALSE(Sensors().KnowsHead(image_));
  EXPECT_FALSE(Sensors().MakeEvent(image_).base_from_camera);
}

TEST_F(RobotSensorsTest, LatenciesShiftTheOdometry) {
  options_.image_latency_s = 0.1;
  EXPECT_NEAR(Sensors().MakeEvent(image_).odometry->x_m, 999.0, 1e-6);
  options_.odom_latency_s = 0.1;
  EXPECT_NEAR(Sensors().MakeEvent(image_).odometry->x_m, 1000.0, 1e-6);
}

TEST_F(RobotSensorsTest, LaterImageIsNotCoveredYet) {
  EXPECT_TRUE(Sensors().OdometryCovers(image_));
  image_.stamp_ns += kSecondNs / 100;
  EXPECT_FALSE(Sensors().OdometryCovers(image_));
}

}  // namespace
}  // namespace rovio_sfm
