#include "rovio_sfm/ros/driver_odometry_message.h"

#include <gtest/gtest.h>
#include <tf2/utils.h>

namespace rovio_sfm {
namespace {

TEST(ToOdometryMessage, HoldsThePlanarPoseWithItsCovariance) {
  OdometryState state;
  state.x_m = 1.0;
  state.y_m = -2.0;
  state.yaw_rad = 0.5;
  state.covariance << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  BaseTwist twist;
  twist.velocity = {0.1, 0.2, 0.3};
  twist.sigma = 0.5;
  const nav_msgs::Odometry message =
      ToOdometryMessage(state, twist, ros::Time(7, 8), "rovio1/odom", "rovio1/base_link");
  EXPECT_EQ(message.header.frame_id, "rovio1/odom");
  EXPECT_EQ(message.child_frame_id, "rovio1/base_link");
  EXPECT_EQ(message.header.stamp, ros::Time(7, 8));
  EXPECT_DOUBLE_EQ(message.pose.pose.position.y, -2.0);
  EXPECT_NEAR(tf2::getYaw(message.pose.pose.orientation), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(message.pose.covariance[0], 1);
  EXPECT_DOUBLE_EQ(message.pose.covariance[1], 2);
  EXPECT_DOUBLE_EQ(message.pose.covariance[5], 3);
  EXPECT_DOUBLE_EQ(message.pose.covariance[7], 4);
  EXPECT_DOUBLE_EQ(message.pose.covariance[35], 6);
  EXPECT_GT(message.pose.covariance[14], 0.0);
  EXPECT_DOUBLE_EQ(message.twist.covariance[35], 0.25);
  EXPECT_DOUBLE_EQ(message.twist.twist.angular.z, 0.3);
}

TEST(ToTransformMessage, KeepsParentAndChild) {
  const Rigid3 parent_from_child{
      Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())), {1, 2, 3}};
  const geometry_msgs::TransformStamped message =
      ToTransformMessage(parent_from_child, ros::Time(1, 2), "a", "b");
  EXPECT_EQ(message.header.frame_id, "a");
  EXPECT_EQ(message.child_frame_id, "b");
  EXPECT_DOUBLE_EQ(message.transform.translation.z, 3.0);
  EXPECT_NEAR(message.transform.rotation.z, std::sin(0.15), 1e-12);
}

}  // namespace
}  // namespace rovio_sfm
