#include "rovio_sfm/ros/drive_tour_node.h"

#include <ros/console.h>
#include <ros/init.h>
#include <tf2/utils.h>

#include <cmath>
#include <stdexcept>

#include "rovio_sfm/app/tour_file.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr double kStepPeriodS = 0.05;
constexpr double kFirstFrameS = 5.0;  // the first frame may have come before this node listened
constexpr double kStirS = 0.3;        // a turn so long is noticed, and soon undone

}  // namespace

DriveTourNode::DriveTourNode(const ros::NodeHandle& handle, const DriveTourOptions& options)
    : handle_(handle),
      options_(options),
      stops_(PlanStops(LoadTourWayPoints(options.tour))),
      twist_(handle_.advertise<geometry_msgs::Twist>(topics::kCmdVel, topics::kCmdVelQueue)),
      odometry_subscriber_(
          handle_.subscribe(topics::kOdom, topics::kOdomQueue, &DriveTourNode::OnOdometry, this)),
      phase_begin_(ros::SteadyTime::now()) {
  if (options_.look == TourLook::kImage) {
    picture_subscriber_ = handle_.subscribe<sensor_msgs::CameraInfo>(
        topics::kCameraInfo, topics::kCameraInfoQueue,
        [this](const sensor_msgs::CameraInfoConstPtr& info) { NotePicture(info->header.stamp); });
  } else if (options_.look == TourLook::kFrame) {
    picture_subscriber_ = handle_.subscribe<FrameEventMsg>(
        topics::kFrames, topics::kFramesQueue,
        [this](const FrameEventMsgConstPtr& frame) { NotePicture(frame->header.stamp); });
  }
  status_subscriber_ = handle_.subscribe<RovioStatus>(
      topics::kStatus, topics::kStatusQueue,
      [this](const RovioStatusConstPtr& status) { num_published_ = status->images_published; });
  timer_ = handle_.createSteadyTimer(ros::WallDuration(kStepPeriodS),
                                     [this](const ros::SteadyTimerEvent&) { Step(); });
  ROS_INFO("%zu stops of %s", stops_.size(), options_.tour.c_str());
}

void DriveTourNode::OnOdometry(const nav_msgs::Odometry& odometry) {
  const double yaw_rad = tf2::getYaw(odometry.pose.pose.orientation);
  const geometry_msgs::Point& position = odometry.pose.pose.position;
  if (!std::isfinite(yaw_rad) || !std::isfinite(position.x) || !std::isfinite(position.y)) return;
  const double before_rad = present_ ? present_->yaw_rad : 0.0;
  present_ = {position.x, position.y,
              before_rad + std::remainder(yaw_rad - before_rad, 2.0 * M_PI)};
  last_odometry_ = ros::SteadyTime::now();
}

void DriveTourNode::NotePicture(const ros::Time& stamp) {
  if (stamp > last_picture_) last_picture_ = stamp;
}

void DriveTourNode::Step() {
  switch (phase_) {
    case Phase::kStarting:
      return Start();
    case Phase::kDriving:
      return Drive();
    case Phase::kLooking:
      return Look();
    case Phase::kStirring:
      return Stir();
  }
}

// The first stop is where the robot stands: its picture may have been taken before this node began.
void DriveTourNode::Start() {
  const double grace_s = options_.look == TourLook::kFrame ? kFirstFrameS : 0.0;
  const bool has_picture = options_.look == TourLook::kNothing || !last_picture_.isZero() ||
                           (num_published_ > 0 && SecondsInPhase() > grace_s);
  if (HasOdometry() && twist_.getNumSubscribers() > 0 && has_picture) {
    next_stop_ = 1;
    origin_ = *present_;
    return EnterPhase(Phase::kDriving);
  }
  if (SecondsInPhase() < options_.ready_timeout_s) return;
  const char* const what = !HasOdometry()                    ? "odometry"
                           : twist_.getNumSubscribers() == 0 ? "driver that listens to cmd_vel"
                                                             : "first picture";
  EndTour(false, std::string("no ") + what);
}

void DriveTourNode::Drive() {
  if (next_stop_ == stops_.size()) return EndTour(true, "the tour is done");
  const bool is_late = SecondsInPhase() > options_.stop_timeout_s;
  if (!HasOdometry()) {
    Stand();
    if (is_late) EndTour(false, "odometry has ceased");
    return;
  }
  const std::optional<BaseVelocity> velocity =
      SteerTo(stops_[next_stop_], RelativeTo(origin_, *present_), options_.steer);
  if (velocity && !is_late) {
    geometry_msgs::Twist twist;
    twist.linear.x = velocity->forward_m_per_s;
    twist.linear.y = velocity->left_m_per_s;
    twist.angular.z = velocity->yaw_rad_per_s;
    twist_.publish(twist);
    return;
  }
  if (is_late) ROS_WARN("stop %zu is not reached in time; looking from here", next_stop_);
  Stand();
  stopped_ = ros::Time::now();
  EnterPhase(Phase::kLooking);
}

void DriveTourNode::Look() {
  const bool has_seen = options_.look == TourLook::kNothing || last_picture_ > stopped_;
  if (has_seen) return GoOn();
  if (SecondsInPhase() < options_.look_timeout_s) return;
  ROS_WARN("no picture at stop %zu", next_stop_);
  if (++num_looks_ < options_.max_looks) return EnterPhase(Phase::kStirring);
  ++num_missed_;
  GoOn();
}

void DriveTourNode::Stir() {
  if (SecondsInPhase() > kStirS) return EnterPhase(Phase::kDriving);
  geometry_msgs::Twist twist;
  twist.angular.z = options_.steer.min_turn_rad_per_s;
  twist_.publish(twist);
}

void DriveTourNode::GoOn() {
  num_looks_ = 0;
  ++next_stop_;
  ROS_INFO_THROTTLE(10, "stop %zu of %zu", next_stop_, stops_.size());
  EnterPhase(Phase::kDriving);
}

void DriveTourNode::EnterPhase(Phase phase) {
  phase_ = phase;
  phase_begin_ = ros::SteadyTime::now();
}

void DriveTourNode::Stand() { twist_.publish(geometry_msgs::Twist()); }

void DriveTourNode::EndTour(bool has_finished, const std::string& message) {
  Stand();
  timer_.stop();
  has_finished_ = has_finished;
  if (has_finished && num_missed_ == 0) {
    ROS_INFO("%s: %zu stops", message.c_str(), stops_.size());
  } else {
    ROS_ERROR("%s: %zu of %zu stops, %zu without a picture", message.c_str(), next_stop_,
              stops_.size(), num_missed_);
  }
  ros::requestShutdown();
}

bool DriveTourNode::HasOdometry() const {
  return present_ && (ros::SteadyTime::now() - last_odometry_).toSec() <= options_.max_odom_age_s;
}

double DriveTourNode::SecondsInPhase() const {
  return (ros::SteadyTime::now() - phase_begin_).toSec();
}

}  // namespace rovio_sfm
