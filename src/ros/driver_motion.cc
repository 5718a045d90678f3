#include "rovio_sfm/ros/driver_motion.h"

#include <nav_msgs/Odometry.h>
#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/driver_odometry_message.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr double kDriveTickS = 0.025;     // how exactly the repeat period is kept
constexpr double kCommandTimeoutS = 1.0;  // a stop must not wait longer behind a lost command
constexpr double kReportTimeoutS = 2.5;   // a robot that never answers is told within 3 s

int64_t RosNs() { return static_cast<int64_t>(ros::Time::now().toNSec()); }

CurlTransportOptions CommandOptions(CurlTransportOptions http) {
  http.total_timeout_s = std::min(http.total_timeout_s, kCommandTimeoutS);
  return http;
}

CurlTransportOptions ReportOptions(CurlTransportOptions http) {
  http.first_byte_timeout_s = std::min(http.first_byte_timeout_s, kReportTimeoutS);
  return http;
}

bool HasTicks(const McuReport& mcu) {
  return std::any_of(mcu.wheels.begin(), mcu.wheels.end(),
                     [](const WheelTicks& wheel) { return wheel.ticks > 0; });
}

}  // namespace

DriverMotion::DriverMotion(const ros::NodeHandle& handle, const DriverOptions& options,
                           const Credentials& credentials, MotionHooks hooks)
    : handle_(handle),
      options_(options),
      hooks_(std::move(hooks)),
      odom_(handle_.advertise<nav_msgs::Odometry>(topics::kOdom, topics::kOdomQueue)),
      odometry_(options.odometry),
      drive_transport_(CommandOptions(options.http), credentials),
      report_transport_(ReportOptions(options.http), credentials),
      drive_loop_(options.drive, &drive_transport_,
                  [this](const DriveCommand& command, const RobotOutcome& outcome) {
                    OnCommand(command, outcome);
                  }),
      reporter_(options.reports, &report_transport_, MakeReporterCallbacks()),
      report_worker_(2, WhenFull::kDropOldest,
                     [this](Question question) {
                       question == Question::kMcu ? reporter_.AskMcu() : reporter_.AskReport();
                     }),
      twist_subscriber_(handle_.subscribe(topics::kCmdVel, topics::kCmdVelQueue,
                                          &DriverMotion::OnTwist, this,
                                          ros::TransportHints().tcpNoDelay())) {
  if (options_.publish_tf) {
    static_broadcaster_.sendTransform(ToTransformMessage(CameraLinkFromOptical(), ros::Time::now(),
                                                         options_.frames.camera_link,
                                                         options_.frames.camera_optical));
  }
  StartTimers();
}

DriverMotion::~DriverMotion() {
  twist_subscriber_.shutdown();
  for (ros::SteadyTimer* const timer : {&drive_timer_, &mcu_timer_, &report_timer_}) timer->stop();
  drive_loop_.Shutdown();
  report_transport_.Cancel();
  report_worker_.Stop();
}

void DriverMotion::StartTimers() {
  const auto every = [this](double seconds, auto tick) {
    return handle_.createSteadyTimer(ros::WallDuration(seconds),
                                     [tick](const ros::SteadyTimerEvent&) { tick(); });
  };
  drive_timer_ = every(kDriveTickS, [this] { drive_loop_.Tick(BootNs()); });
  mcu_timer_ = every(1.0 / options_.mcu_rate_hz, [this] { report_worker_.Push(Question::kMcu); });
  report_timer_ =
      every(1.0 / options_.report_rate_hz, [this] { report_worker_.Push(Question::kReport); });
}

RobotReporter::Callbacks DriverMotion::MakeReporterCallbacks() {
  RobotReporter::Callbacks callbacks;
  callbacks.on_mcu = [this](const McuReport& mcu, const ReadingTime& time) { OnMcu(mcu, time); };
  callbacks.on_lost_mcu = [this] {
    if (drive_loop_.IsMoving()) odometry_.AddLostReading(1.0 / options_.mcu_rate_hz);
    MutexLock lock(mutex_);
    ++state_.num_lost_readings;
  };
  callbacks.on_report = [this](const RobotReport& report) {
    MutexLock lock(mutex_);
    state_.report = report;
    if (reporter_.IsSettling()) foreign_hand_.NoteOwnSettings(SteadyNs());
    foreign_hand_.Look(report, SteadyNs());
    report_came_.notify_all();
  };
  callbacks.on_link = [this](bool is_up, const std::string& reason) { OnLink(is_up, reason); };
  callbacks.on_settings = [this](bool has_obeyed, const SomeSettings& settings) {
    if (has_obeyed) {
      ROS_INFO_STREAM_NAMED("settings", "camera: " << Describe(settings));
    } else {
      ROS_WARN_STREAM_NAMED("settings",
                            "the robot did not take the settings; it has " << Describe(settings));
    }
    hooks_.on_settings(settings);
  };
  callbacks.now_ns = RosNs;
  callbacks.steady_ns = SteadyNs;
  return callbacks;
}

void DriverMotion::OnTwist(const geometry_msgs::Twist& twist) {
  drive_loop_.SetWish({twist.linear.x, twist.linear.y, twist.angular.z}, BootNs());
}

void DriverMotion::OnCommand(const DriveCommand& command, const RobotOutcome& outcome) {
  if (command.code != DriveCode::kStop) hooks_.on_motion(true, SteadyNs());
  MutexLock lock(mutex_);
  foreign_hand_.NoteOwnMotion(SteadyNs());
  ++state_.num_commands;
  if (!outcome.IsOk()) {
    ++state_.num_failed_commands;
    if (state_.last_command_fault.empty()) {
      ROS_WARN_STREAM_NAMED("drive", "a drive command failed: " << outcome.message);
    }
  }
  state_.last_command_fault = outcome.message;
}

void DriverMotion::OnMcu(const McuReport& mcu, const ReadingTime& time) {
  // The first reading holds what happened before this node began.
  const BaseMotion motion = is_odometry_begun_ ? odometry_.Add(mcu.wheels) : BaseMotion::Zero();
  const bool has_moved = is_odometry_begun_ && HasTicks(mcu);
  is_odometry_begun_ = true;
  PublishPose(mcu, motion, time);
  const bool is_moving = has_moved || drive_loop_.IsMoving();
  hooks_.on_motion(is_moving, SteadyNs());
  MutexLock lock(mutex_);
  if (drive_loop_.IsMoving()) foreign_hand_.NoteOwnMotion(time.steady_ns);
  foreign_hand_.Look(mcu, time.steady_ns);
  state_.mcu = mcu;
  state_.is_moving = is_moving;
}

void DriverMotion::PublishPose(const McuReport& mcu, const BaseMotion& motion,
                               const ReadingTime& time) {
  BaseTwist twist;
  const double interval_s = static_cast<double>(time.steady_ns - last_mcu_ns_) * 1e-9;
  last_mcu_ns_ = time.steady_ns;
  if (time.stamp_ns <= 0) return;  // no /clock yet
  const ros::Time stamp = ToTime(time.stamp_ns);
  if (interval_s > 0.0) {
    twist.velocity = motion / interval_s;
    twist.sigma = options_.odometry.tick_sigma / options_.odometry.ticks_per_m / interval_s;
  }
  const DriverFrames& frames = options_.frames;
  odom_.publish(ToOdometryMessage(odometry_.State(), twist, stamp, frames.odom, frames.base));
  if (!options_.publish_tf) return;
  broadcaster_.sendTransform(
      {ToTransformMessage(OdomFromBase(odometry_.State()), stamp, frames.odom, frames.base),
       ToTransformMessage(BaseFromCameraLink(mcu.head_position, options_.head), stamp, frames.base,
                          frames.camera_link)});
}

void DriverMotion::OnLink(bool is_up, const std::string& reason) {
  if (is_up) {
    ROS_INFO_STREAM_NAMED("link", "the robot at " << options_.http.host << " answers");
  } else {
    ROS_WARN_STREAM_NAMED("link", "the robot at " << options_.http.host << " is away: " << reason);
  }
  hooks_.on_link(is_up, SteadyNs());
  MutexLock lock(mutex_);
  state_.is_up = is_up;
  state_.reason = reason;
}

RobotState DriverMotion::State() const {
  MutexLock lock(mutex_);
  RobotState state = state_;
  state.foreign_hand = foreign_hand_.Reason(SteadyNs());
  return state;
}

void DriverMotion::NoteOwnMotion() {
  MutexLock lock(mutex_);
  foreign_hand_.NoteOwnMotion(SteadyNs());
}

void DriverMotion::NoteOwnSettings() {
  MutexLock lock(mutex_);
  foreign_hand_.NoteOwnSettings(SteadyNs());
}

bool DriverMotion::WaitForReport(double seconds,
                                 const std::function<bool(const RobotReport&)>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  MutexLock lock(mutex_);
  while (!state_.report || !condition(*state_.report)) {
    if (report_came_.wait_until(mutex_, end) == std::cv_status::timeout) return false;
  }
  return true;
}

}  // namespace rovio_sfm
