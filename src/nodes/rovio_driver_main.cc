#include <ros/ros.h>

#include <exception>

#include "rovio_sfm/app/driver_credentials.h"
#include "rovio_sfm/ros/rovio_driver_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  rovio_sfm::InitNode(argc, argv, "rovio_driver");
  try {
    ros::NodeHandle handle, private_handle("~");
    const auto options = rovio_sfm::LoadDriverOptions(handle, private_handle);
    rovio_sfm::RovioDriverNode node(handle, private_handle, options,
                                    rovio_sfm::LoadCredentials(options.credentials_file));
    rovio_sfm::SpinUntilStopped();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
