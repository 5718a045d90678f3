#pragma once

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/RovioStatus.h>
#include <sensor_msgs/CameraInfo.h>

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/drive_tour_options.h"
#include "rovio_sfm/rovio/tour_plan.h"

namespace rovio_sfm {

// Drives a tour through cmd_vel with odometry as its feedback: to each stop, stand, look. Where no
// picture comes it turns a little and drives to the stop once more: a driver that takes one picture
// per stop then takes another. All in callbacks of one thread; ends ROS when it is done.
class DriveTourNode {
 public:
  DriveTourNode(const ros::NodeHandle& handle, const DriveTourOptions& options);

  // Whether every stop was reached and looked at; meaningful once ROS has ended.
  bool HasSucceeded() const { return has_finished_ && num_missed_ == 0; }

 private:
  enum class Phase { kStarting, kDriving, kLooking, kStirring };

  void OnOdometry(const nav_msgs::Odometry& odometry);
  void NotePicture(const ros::Time& stamp);
  void Step();
  void Start();
  void Drive();
  void Look();
  void Stir();
  void GoOn();
  void EnterPhase(Phase phase);
  void Stand();
  void EndTour(bool has_finished, const std::string& message);
  bool HasOdometry() const;
  double SecondsInPhase() const;

  ros::NodeHandle handle_;
  const DriveTourOptions options_;
  const std::vector<PlanarPose> stops_;
  ros::Publisher twist_;
  ros::Subscriber odometry_subscriber_, picture_subscriber_, status_subscriber_;
  ros::SteadyTimer timer_;
  Phase phase_ = Phase::kStarting;
  ros::SteadyTime phase_begin_;
  ros::SteadyTime last_odometry_;
  ros::Time stopped_;                  // stamp of the moment when it stood still
  ros::Time last_picture_;             // stamp of the newest picture
  std::optional<PlanarPose> present_;  // in odom, yaw unwrapped
  PlanarPose origin_;                  // where the tour began, in odom
  uint64_t num_published_ = 0;         // images, as the driver counts them
  size_t next_stop_ = 0;
  int num_looks_ = 0;  // at this stop, in vain
  size_t num_missed_ = 0;
  bool has_finished_ = false;
};

}  // namespace rovio_sfm
