#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <rovio_sfm/Dock.h>
#include <rovio_sfm/SetCamera.h>
#include <rovio_sfm/SetHead.h>

#include "rovio_sfm/ros/driver_motion.h"

namespace rovio_sfm {

// The services of the driver, on a spinner and a connection of their own, so that a slow robot
// holds up neither cmd_vel nor images. Borrows the motion, to read settings back.
class DriverServices {
 public:
  DriverServices(const ros::NodeHandle& handle, const DriverOptions& options,
                 const Credentials& credentials, DriverMotion* motion);
  ~DriverServices();

 private:
  bool SetHead(SetHead::Request& request, SetHead::Response& response);
  bool SetCamera(SetCamera::Request& request, SetCamera::Response& response);
  bool Dock(Dock::Request& request, Dock::Response& response);
  Status ChangeSettings(const rovio_sfm::SetCamera::Request& request);

  DriverMotion* const motion_;
  CurlTransport transport_;
  RovioClient client_;  // one service at a time: the queue has one thread
  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  ros::ServiceServer head_server_;
  ros::ServiceServer camera_server_;
  ros::ServiceServer dock_server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace rovio_sfm
