#include "rovio_sfm/ros/drive_tour_node.h"

#include <ros/console.h>
#include <ros/init.h>
#include <tf2/utils.h>

#include <cmath>
#include <stdexcept>

#include "rovio_sfm/app/option_reader.h"
#include "rovio_sfm/app/tour_file.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr double kStepPeriodS = 0.05;
constexpr double kFirstFrameS = 5.0;  // the first frame may have come before this node listened
constexpr double kStirS = 0.3;        // a turn so long is noticed, and soon undone
constexpr double kDegree = M_PI / 180.0;

void ReadDegrees(OptionReader* reader, const std::string& name, double* value_rad) {
  double degrees = *value_rad / kDegree;
  reader->Read(name, &degrees);
  *value_rad = degrees * kDegree;
}

SteerOptions ReadSteer(OptionReader reader) {
  SteerOptions steer;
  reader.Read("position_tolerance_m", &steer.position_tolerance_m);
  ReadDegrees(&reader, "yaw_tolerance_deg", &steer.yaw_tolerance_rad);
  ReadDegrees(&reader, "turn_first_deg", &steer.turn_first_rad);
  reader.Read("max_speed_m_per_s", &steer.max_speed_m_per_s);
  reader.Read("min_speed_m_per_s", &steer.min_speed_m_per_s);
  reader.Read("max_turn_rad_per_s", &steer.max_turn_rad_per_s);
  reader.Read("min_turn_rad_per_s", &steer.min_turn_rad_per_s);
  reader.Read("approach_s", &steer.approach_s);
  reader.RefuseUnknown();
  return steer;
}

TourLook ReadLook(OptionReader* reader) {
  std::string look = "image";
  reader->Read("look", &look);
  if (look == "image") return TourLook::kImage;
  if (look == "frame") return TourLook::kFrame;
  if (look != "nothing") reader->Fail("look", "expected one of nothing image frame");
  return TourLook::kNothing;
}

}  // namespace

bool DriveTourOptions::IsValid(std::string* error) const {
  if (tour.empty()) {
    *error = "tour must name a YAML file of way-points";
    return false;
  }
  for (const double seconds : {look_timeout_s, ready_timeout_s, stop_timeout_s, max_odom_age_s}) {
    if (seconds >= 0.1 && seconds <= 3600.0) continue;
    *error = "time-outs and max_odom_age_s must be 0.1 … 3600 s";
    return false;
  }
  if (max_looks < 1 || max_looks > 100) {
    *error = "max_looks must be 1 … 100";
    return false;
  }
  return steer.IsValid(error);
}

DriveTourOptions LoadDriveTourOptions(const YAML::Node& parameters) {
  OptionReader reader(parameters, "drive_tour");
  DriveTourOptions options;
  reader.Read("tour", &options.tour);
  options.look = ReadLook(&reader);
  reader.Read("look_timeout_s", &options.look_timeout_s);
  reader.Read("max_looks", &options.max_looks);
  reader.Read("ready_timeout_s", &options.ready_timeout_s);
  reader.Read("stop_timeout_s", &options.stop_timeout_s);
  reader.Read("max_odom_age_s", &options.max_odom_age_s);
  options.steer = ReadSteer(reader.Group("steer"));
  reader.RefuseUnknown();
  std::string error;
  if (!options.IsValid(&error)) throw std::runtime_error("drive_tour: " + error);
  return options;
}

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
  Finish(false, std::string("no ") + what);
}

void DriveTourNode::Drive() {
  if (next_stop_ == stops_.size()) return Finish(true, "the tour is done");
  const bool is_late = SecondsInPhase() > options_.stop_timeout_s;
  if (!HasOdometry()) {
    Stand();
    if (is_late) Finish(false, "odometry has ceased");
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

void DriveTourNode::Finish(bool has_finished, const std::string& message) {
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
