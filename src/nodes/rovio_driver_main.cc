#include <ros/ros.h>

#include <csignal>
#include <exception>

#include "rovio_sfm/ros/driver_credentials.h"
#include "rovio_sfm/ros/rovio_driver_node.h"

namespace {

// ROS handles SIGINT only; both shall stop the robot.
void ShutDown(int) { ros::requestShutdown(); }

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "rovio_driver");
  std::signal(SIGTERM, ShutDown);
  try {
    ros::NodeHandle handle, private_handle("~");
    const rovio_sfm::DriverOptions options = rovio_sfm::LoadDriverOptions(handle, private_handle);
    rovio_sfm::RovioDriverNode node(handle, private_handle, options,
                                    rovio_sfm::LoadCredentials(options.credentials_file));
    ros::AsyncSpinner spinner(1);
    spinner.start();
    ros::waitForShutdown();
    spinner.stop();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
