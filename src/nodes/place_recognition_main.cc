#include "rovio_sfm/ros/place_recognition_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  return rovio_sfm::RunNode(
      argc, argv, "place_recognition", [](ros::NodeHandle node, ros::NodeHandle private_node) {
        const auto options =
            rovio_sfm::LoadPlaceRecognitionNodeOptions(rovio_sfm::ParametersOf(private_node));
        rovio_sfm::PlaceRecognitionNode places(options, node, private_node);
        rovio_sfm::SpinUntilStopped([&] { places.Tick(); });
        return 0;
      });
}
