#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include "rovio_sfm/ros/diagnostic_pace.h"
#include "rovio_sfm/ros/driver_images.h"
#include "rovio_sfm/ros/driver_motion.h"
#include "rovio_sfm/ros/driver_services.h"

namespace rovio_sfm {

// The driver of one robot: images, motion, services, status and diagnostics. Callbacks never wait
// for the robot. The destructor stops the robot; call it before ROS is shut down, or after.
class RovioDriverNode {
 public:
  // Throws std::runtime_error where another node publishes what this one would.
  RovioDriverNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                  const DriverOptions& options, const Credentials& credentials);

 private:
  using Diagnostics = diagnostic_updater::DiagnosticStatusWrapper;

  void PublishStatus();
  void DiagnoseRobot(Diagnostics& out);
  void DiagnoseImages(Diagnostics& out);
  void DiagnoseMotion(Diagnostics& out);

  ros::NodeHandle handle_;
  ros::Publisher status_;
  DriverImages images_;
  DriverMotion motion_;  // tells images_ about motion, so it ends before them
  DriverServices services_;
  diagnostic_updater::Updater updater_;
  DiagnosticPace pace_;
  ros::SteadyTimer status_timer_, tick_timer_;
};

// The options from the node's parameters; throws std::runtime_error that names the parameter.
DriverOptions LoadDriverOptions(const ros::NodeHandle& handle,
                                const ros::NodeHandle& private_handle);

}  // namespace rovio_sfm
