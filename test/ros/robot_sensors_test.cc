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
    header_.stamp = ToTime(100 * kSecondNs);
    header_.frame_id = "camera_optical";
  }

  void AddHead() {
    geometry_msgs::TransformStamped head;
    head.header.frame_id = "base_link";
    head.child_frame_id = "camera_optical";
    head.transform = ToTransform({Eigen::Quaterniond::Identity(), {0.1, 0.2, 0.3}});
    transforms_.setTransform(head, "test", true);
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
  std_msgs::Header header_;
};

TEST_F(RobotSensorsTest, EventHoldsOdometryAndHeadAtTheStamp) {
  AddHead();
  const ImageEvent event = Sensors().MakeEvent(header_, "7", nullptr);
  EXPECT_EQ(event.name, "7");
  ASSERT_TRUE(event.odometry && event.base_from_camera);
  EXPECT_DOUBLE_EQ(event.odometry->x_m, 1000.0);
  EXPECT_DOUBLE_EQ(event.base_from_camera->translation.y(), 0.2);
}

TEST_F(RobotSensorsTest, UnknownHeadStaysUnknown) {
  EXPECT_FALSE(Sensors().KnowsHead(header_));
  EXPECT_FALSE(Sensors().MakeEvent(header_, "", nullptr).base_from_camera);
}

TEST_F(RobotSensorsTest, LatenciesShiftTheOdometry) {
  options_.image_latency_s = 0.1;
  EXPECT_NEAR(Sensors().MakeEvent(header_, "", nullptr).odometry->x_m, 999.0, 1e-6);
  options_.odom_latency_s = 0.1;
  EXPECT_NEAR(Sensors().MakeEvent(header_, "", nullptr).odometry->x_m, 1000.0, 1e-6);
}

TEST_F(RobotSensorsTest, LaterImageIsNotCoveredYet) {
  EXPECT_TRUE(Sensors().OdometryCovers(header_));
  header_.stamp += ros::Duration(0.01);
  EXPECT_FALSE(Sensors().OdometryCovers(header_));
}

TEST_F(RobotSensorsTest, LatencyOutOfRangeIsNamed) {
  options_.odom_latency_s = 5.0;
  std::string error;
  EXPECT_FALSE(options_.IsValid(&error));
  EXPECT_NE(error.find("odom_latency_s"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
