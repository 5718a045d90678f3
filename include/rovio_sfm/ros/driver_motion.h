#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <functional>
#include <optional>
#include <string>

#include "rovio_sfm/app/driver_options.h"
#include "rovio_sfm/rovio/drive_loop.h"
#include "rovio_sfm/rovio/foreign_hand.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// What is known about the robot, for status and diagnostics.
struct RobotState {
  bool is_up = false;
  std::string reason = "not reached yet";
  bool is_moving = false;
  std::optional<McuReport> mcu;
  std::optional<RobotReport> report;
  uint64_t num_lost_readings = 0;
  uint64_t num_commands = 0;
  uint64_t num_failed_commands = 0;
  std::string last_command_fault;  // empty: the last command succeeded
  std::string foreign_hand;        // who else seems to use the robot; empty: nobody
};

// What the wheels' side tells the images' side, from its workers.
struct MotionHooks {
  std::function<void(bool is_moving, int64_t now_ns)> on_motion;  // for each reading; steady time
  std::function<void(bool is_up, int64_t now_ns)> on_link;        // when it changes; steady time
  // Once each time the robot comes: the camera has its settings, or never will.
  std::function<void(const SomeSettings& settings)> on_settings;
};

// Wheels and health of one robot: commands from cmd_vel on one worker, readings on another. It
// publishes odom and tf. The destructor stops the robot.
class DriverMotion {
 public:
  DriverMotion(const ros::NodeHandle& handle, const DriverOptions& options,
               const Credentials& credentials, MotionHooks hooks);
  ~DriverMotion();

  RobotState State() const EXCLUDES(mutex_);

  // What this driver does to the robot by its services is no foreign hand.
  void NoteOwnMotion() EXCLUDES(mutex_);
  void NoteOwnSettings() EXCLUDES(mutex_);

  // Waits until a report comes that satisfies the condition; false after this many seconds.
  bool WaitForReport(double seconds, const std::function<bool(const RobotReport&)>& condition)
      EXCLUDES(mutex_);

 private:
  enum class Question { kMcu, kReport };

  RobotReporter::Callbacks MakeReporterCallbacks();
  void OnTwist(const geometry_msgs::Twist& twist);
  void OnCommand(const DriveCommand& command, const RobotOutcome& outcome) EXCLUDES(mutex_);
  void OnMcu(const McuReport& mcu, const ReadingTime& time) EXCLUDES(mutex_);
  void OnLink(bool is_up, const std::string& reason) EXCLUDES(mutex_);
  void PublishPose(const McuReport& mcu, const BaseMotion& motion, const ReadingTime& time);
  void StartTimers();

  ros::NodeHandle handle_;
  const DriverOptions options_;
  const MotionHooks hooks_;
  ros::Publisher odom_;
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  mutable Mutex mutex_;
  std::condition_variable_any report_came_;
  RobotState state_ GUARDED_BY(mutex_);
  ForeignHand foreign_hand_ GUARDED_BY(mutex_);
  OmniOdometry odometry_;    // of the report worker
  int64_t last_mcu_ns_ = 0;  // steady; of the report worker
  bool is_odometry_begun_ = false;
  CurlTransport drive_transport_;
  CurlTransport report_transport_;
  DriveLoop drive_loop_;
  RobotReporter reporter_;  // of the report worker
  // Two questions wait at most; older ones are dropped: a slow robot is not asked faster.
  Worker<Question> report_worker_;
  ros::Subscriber twist_subscriber_;
  ros::SteadyTimer drive_timer_;
  ros::SteadyTimer mcu_timer_;
  ros::SteadyTimer report_timer_;
};

}  // namespace rovio_sfm
