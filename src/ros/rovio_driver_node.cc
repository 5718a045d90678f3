#include "rovio_sfm/ros/rovio_driver_node.h"

#include <ros/console.h>
#include <rovio_sfm/RovioStatus.h>

#include <algorithm>

#include "rovio_sfm/ros/run_node.h"
#include "rovio_sfm/ros/sole_publisher.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kStatusPeriodS = 1.0;
constexpr double kTickPeriodS = 0.1;
constexpr int kLowBattery = 106;  // below it the robot goes home by itself

// "/a/rovio1/" becomes "a/rovio1".
std::string RobotName(const ros::NodeHandle& handle) {
  std::string name = handle.getNamespace();
  name.erase(0, std::min(name.find_first_not_of('/'), name.size()));
  return name;
}

// Claims the robot, unless another driver did before.
ros::Publisher AdvertiseAlone(ros::NodeHandle handle) {
  ros::Publisher status =
      handle.advertise<RovioStatus>(topics::kStatus, topics::kStatusQueue, true);
  RequireSolePublisher(handle, {topics::kStatus, topics::kOdom, topics::kImageCompressed});
  return status;
}

template <typename T>
uint8_t Byte(T value) {
  return static_cast<uint8_t>(std::clamp<int>(static_cast<int>(value), 0, 255));
}

// What is not known is 0, as the message says; its sentence names it.
void FillReport(const RobotReport& report, RovioStatus* status) {
  status->home_saved = report.home_saved.value_or(false);
  status->state = Byte(report.state.value_or(0));
  status->wifi_strength = Byte(report.wifi_strength.value_or(0));
  status->northstar_strength = static_cast<uint16_t>(report.signal_strength.value_or(0));
  status->battery = Byte(report.battery.value_or(0));
  status->head_position = Byte(report.head_position.value_or(0));
  status->is_charging = report.charging == 80;
  status->is_on_dock = report.charging.value_or(0) >= 64;
  status->obstacle = report.obstacle.value_or(false);
  status->resolution = Byte(report.camera.resolution.value_or(0));
  status->compression = Byte(report.camera.compression.value_or(0));
  status->frame_rate = Byte(report.camera.frame_rate.value_or(0));
  status->brightness = Byte(report.camera.brightness.value_or(0));
  if (!report.odd_fields.empty()) status->message += "; GetReport: " + report.odd_fields;
}

void AddIfKnown(const std::string& name, const std::optional<int>& value,
                diagnostic_updater::DiagnosticStatusWrapper* out) {
  out->add(name, value ? std::to_string(*value) : "not known");
}

void FillMcu(const McuReport& mcu, RovioStatus* status) {
  status->battery = Byte(mcu.battery);
  status->head_position = Byte(mcu.head_position);
  status->is_charging = mcu.is_charging;
  status->is_on_dock = mcu.is_on_dock;
  status->obstacle = mcu.obstacle;
}

}  // namespace

RovioDriverNode::RovioDriverNode(const ros::NodeHandle& handle,
                                 const ros::NodeHandle& private_handle,
                                 const DriverOptions& options, const Credentials& credentials)
    : handle_(handle),
      status_(AdvertiseAlone(handle)),
      images_(handle, options, credentials),
      motion_(handle, options, credentials,
              {[this](bool is_moving, int64_t now_ns) { images_.NoteMotion(is_moving, now_ns); },
               [this](bool is_up, int64_t now_ns) { images_.NoteLink(is_up, now_ns); },
               [this](const SomeSettings& settings) { images_.NoteSettings(settings); }}),
      services_(handle, options, credentials, &motion_),
      updater_(handle, private_handle),
      pace_(&updater_) {
  if (RobotName(handle).empty()) {
    ROS_WARN("rovio_driver runs in the root namespace; give each robot one of its own");
  }
  updater_.setHardwareID("rovio " + options.http.host + ":" + std::to_string(options.http.port));
  updater_.add("robot", this, &RovioDriverNode::DiagnoseRobot);
  updater_.add("images", this, &RovioDriverNode::DiagnoseImages);
  updater_.add("motion", this, &RovioDriverNode::DiagnoseMotion);
  tick_timer_ = handle_.createSteadyTimer(ros::WallDuration(kTickPeriodS),
                                          [this](const ros::SteadyTimerEvent&) { pace_.Tick(); });
  status_timer_ = handle_.createSteadyTimer(
      ros::WallDuration(kStatusPeriodS), [this](const ros::SteadyTimerEvent&) { PublishStatus(); });
}

void RovioDriverNode::PublishStatus() {
  const RobotState state = motion_.State();
  RovioStatus status;
  status.header.stamp = ros::Time::now();
  status.is_online = state.is_up;
  status.message = state.reason;
  status.is_moving = state.is_moving;
  status.image_link = NameOf(images_.Link());
  if (state.report) FillReport(*state.report, &status);
  if (state.mcu) FillMcu(*state.mcu, &status);
  status.images_published = images_.NumPublished();
  status.images_dropped = images_.NumDropped();
  status_.publish(status);
  images_.CheckSettings(SteadyNs());
}

void RovioDriverNode::DiagnoseRobot(Diagnostics& out) {
  const RobotState state = motion_.State();
  if (!state.is_up) {
    out.summary(DiagnosticStatus::ERROR, "no link: " + state.reason);
  } else if (!state.foreign_hand.empty()) {
    out.summary(DiagnosticStatus::WARN, state.foreign_hand);
  } else if (state.mcu && state.mcu->battery < kLowBattery) {
    out.summary(DiagnosticStatus::WARN, "battery low");
  } else if (state.report && !state.report->odd_fields.empty()) {
    out.summary(DiagnosticStatus::WARN, "GetReport: " + state.report->odd_fields);
  } else {
    out.summary(DiagnosticStatus::OK, state.reason);
  }
  if (state.mcu) {
    out.add("battery (106 to 127 normal)", state.mcu->battery);
    out.add("charging", state.mcu->is_charging);
    out.add("on dock", state.mcu->is_on_dock);
    out.add("head position", state.mcu->head_position);
  }
  if (!state.report) return;
  AddIfKnown("wifi strength (0 to 254)", state.report->wifi_strength, &out);
  AddIfKnown("NorthStar strength (0 to 65535)", state.report->signal_strength, &out);
  out.add("camera", Describe(state.report->camera));
}

void RovioDriverNode::DiagnoseImages(Diagnostics& out) {
  const ImagesState state = images_.TakeState();
  const ImageCounters& counters = images_.Counters();
  const auto level = state.link == ImageLink::kDown         ? DiagnosticStatus::ERROR
                     : state.link == ImageLink::kConnecting ? DiagnosticStatus::WARN
                                                            : DiagnosticStatus::OK;
  out.summary(level, std::string(NameOf(state.link)) + ": " + state.reason);
  if (!state.is_calibrated) {
    out.mergeSummary(DiagnosticStatus::WARN, "uncalibrated: no calibration of their size");
  }
  const double interval_s = state.figures.mean_interval_s;
  out.add("rate (1/s)", interval_s > 0.0 ? 1.0 / interval_s : 0.0);
  out.add("jitter (s)", state.figures.jitter_s);
  out.add("mean transfer (s)", state.figures.mean_transfer_s);
  out.add("longest transfer (s)", state.figures.max_transfer_s);
  out.add("received", counters.num_images.load());
  out.add("published", state.num_published);
  out.add("dropped, no time", state.num_dropped);
  out.add("dropped, no /clock", state.num_without_time);
  out.add("dropped, truncated", counters.num_truncated.load());
  out.add("dropped, corrupt", counters.num_corrupt.load());
  out.add("dropped, too large", counters.num_too_large.load());
  out.add("malformed answers", counters.num_malformed.load());
  out.add("failed attempts", counters.num_failures.load());
  out.add("reconnects", counters.num_reconnects.load());
}

void RovioDriverNode::DiagnoseMotion(Diagnostics& out) {
  const RobotState state = motion_.State();
  if (state.last_command_fault.empty()) {
    out.summary(DiagnosticStatus::OK, state.is_moving ? "moving" : "at rest");
  } else {
    out.summary(DiagnosticStatus::WARN, "last command failed: " + state.last_command_fault);
  }
  out.add("commands", state.num_commands);
  out.add("failed commands", state.num_failed_commands);
  out.add("lost tick readings", state.num_lost_readings);
}

DriverOptions LoadDriverOptions(const ros::NodeHandle& handle,
                                const ros::NodeHandle& private_handle) {
  return LoadDriverOptions(ParametersOf(private_handle), RobotName(handle));
}

}  // namespace rovio_sfm
