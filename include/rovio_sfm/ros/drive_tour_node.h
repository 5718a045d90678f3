#pragma once

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/RovioStatus.h>
#include <sensor_msgs/CameraInfo.h>
#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/rovio/tour_plan.h"

namespace rovio_sfm {

// For what the robot waits at a stop.
enum class TourLook { kNothing, kImage, kFrame };

struct DriveTourOptions {
  std::string tour;                  // path of the YAML file
  TourLook look = TourLook::kImage;  // kImage: a camera_info after the stop; kFrame: its FrameEvent
  double look_timeout_s = 15.0;      // then it moves a little, and looks again
  int max_looks = 4;                 // at one stop; then the tour goes on, one picture short
  double ready_timeout_s = 60.0;     // to find odometry, a driver and a first picture
  double stop_timeout_s = 20.0;      // to reach one stop; then it looks from where it is
  double max_odom_age_s = 1.0;       // older odometry: it stands and waits
  SteerOptions steer;

  bool IsValid(std::string* error) const;
};

// Reads the node's parameters, those of config/drive_tour.yaml; throws std::runtime_error that
// names the parameter.
DriveTourOptions LoadDriveTourOptions(const YAML::Node& parameters);

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
  void Finish(bool has_finished, const std::string& message);
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
