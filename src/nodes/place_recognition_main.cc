#include <ros/ros.h>

#include <exception>

#include "rovio_sfm/ros/place_recognition_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  rovio_sfm::InitNode(argc, argv, "place_recognition");
  try {
    ros::NodeHandle node, private_node("~");
    const auto options =
        rovio_sfm::LoadPlaceRecognitionNodeOptions(rovio_sfm::ParametersOf(private_node));
    rovio_sfm::PlaceRecognitionNode places(options, node, private_node);
    rovio_sfm::SpinUntilStopped([&] { places.Tick(); });
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
