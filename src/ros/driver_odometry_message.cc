#include "rovio_sfm/ros/driver_odometry_message.h"

#include <tf2_eigen/tf2_eigen.h>

#include <cmath>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr double kHeightVariance = 0.002 * 0.002;              // m²
constexpr double kTiltVariance = Radians(0.5) * Radians(0.5);  // rad²

}  // namespace

Rigid3 OdomFromBase(const OdometryState& state) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(state.yaw_rad, Eigen::Vector3d::UnitZ())),
          {state.x_m, state.y_m, 0.0}};
}

nav_msgs::Odometry ToOdometryMessage(const OdometryState& state, const BaseTwist& twist,
                                     ros::Time stamp, const std::string& odom_frame,
                                     const std::string& base_frame) {
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = odom_frame;
  message.child_frame_id = base_frame;
  const Rigid3 odom_from_base = OdomFromBase(state);
  message.pose.pose.position = tf2::toMsg(odom_from_base.translation);
  message.pose.pose.orientation = tf2::toMsg(odom_from_base.rotation);
  constexpr size_t kPlanar[3] = {0, 1, 5};  // x, y, yaw among x y z roll pitch yaw
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      message.pose.covariance[6 * kPlanar[row] + kPlanar[column]] =
          state.covariance(static_cast<int>(row), static_cast<int>(column));
    }
    message.twist.covariance[7 * kPlanar[row]] = twist.sigma * twist.sigma;
  }
  for (auto* const covariance : {&message.pose.covariance, &message.twist.covariance}) {
    (*covariance)[14] = kHeightVariance;
    (*covariance)[21] = (*covariance)[28] = kTiltVariance;
  }
  message.twist.twist.linear.x = twist.velocity.x();
  message.twist.twist.linear.y = twist.velocity.y();
  message.twist.twist.angular.z = twist.velocity.z();
  return message;
}

geometry_msgs::TransformStamped ToTransformMessage(const Rigid3& parent_from_child, ros::Time stamp,
                                                   const std::string& parent,
                                                   const std::string& child) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = parent_from_child.translation.x();
  message.transform.translation.y = parent_from_child.translation.y();
  message.transform.translation.z = parent_from_child.translation.z();
  message.transform.rotation = tf2::toMsg(parent_from_child.rotation);
  return message;
}

}  // namespace rovio_sfm
