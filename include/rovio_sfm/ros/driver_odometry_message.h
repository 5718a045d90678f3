#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>

#include <string>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/rovio/omni_odometry.h"

namespace rovio_sfm {

// Velocity of the base over the last interval, in the base: m/s, m/s, rad/s.
struct BaseTwist {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double sigma = 0.0;  // one standard deviation of each
};

// The planar pose as odom_from_base. Height, roll and pitch are those of a flat floor, with the
// spread of a rocking robot.
nav_msgs::Odometry ToOdometryMessage(const OdometryState& state, const BaseTwist& twist,
                                     ros::Time stamp, const std::string& odom_frame,
                                     const std::string& base_frame);

// parent_from_child as a tf message.
geometry_msgs::TransformStamped ToTransformMessage(const Rigid3& parent_from_child, ros::Time stamp,
                                                   const std::string& parent,
                                                   const std::string& child);

// odom_from_base of a planar state.
Rigid3 OdomFromBase(const OdometryState& state);

}  // namespace rovio_sfm
