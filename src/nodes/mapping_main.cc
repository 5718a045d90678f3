#include <ros/ros.h>

#include <exception>

#include "rovio_sfm/ros/mapping_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  rovio_sfm::InitNode(argc, argv, "mapping");
  try {
    ros::NodeHandle node, private_node("~");
    const auto options = rovio_sfm::LoadMappingNodeOptions(rovio_sfm::ParametersOf(private_node));
    rovio_sfm::MappingNode mapping(options, node, private_node);
    rovio_sfm::SpinUntilStopped([&] { mapping.Tick(); });
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
