#include <ros/ros.h>

#include <exception>
#include <random>

#include "rovio_sfm/ros/frontend_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  rovio_sfm::InitNode(argc, argv, "frontend");
  try {
    ros::NodeHandle node, private_node("~");
    const auto options = rovio_sfm::LoadFrontendNodeOptions(rovio_sfm::ParametersOf(private_node),
                                                            node.getNamespace());
    rovio_sfm::FrontendNode frontend(options, std::random_device()(), node, private_node);
    rovio_sfm::SpinUntilStopped([&] { frontend.Tick(); });
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
