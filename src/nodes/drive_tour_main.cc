#include <ros/ros.h>

#include <exception>

#include "rovio_sfm/ros/drive_tour_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "drive_tour");
  try {
    ros::NodeHandle handle, private_handle("~");
    const rovio_sfm::DriveTourNode node(
        handle, rovio_sfm::LoadDriveTourOptions(rovio_sfm::ParametersOf(private_handle)));
    ros::spin();
    return node.HasSucceeded() ? 0 : 1;
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
