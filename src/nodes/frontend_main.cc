#include <random>

#include "rovio_sfm/ros/frontend_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  return rovio_sfm::RunNode(
      argc, argv, "frontend", [](ros::NodeHandle node, ros::NodeHandle private_node) {
        const auto options = rovio_sfm::LoadFrontendNodeOptions(
            rovio_sfm::ParametersOf(private_node), node.getNamespace());
        rovio_sfm::FrontendNode frontend(options, std::random_device()(), node, private_node);
        rovio_sfm::SpinUntilStopped([&] { frontend.Tick(); });
        return 0;
      });
}
