#include "rovio_sfm/ros/drive_tour_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  return rovio_sfm::RunNode(
      argc, argv, "drive_tour", [](ros::NodeHandle node, ros::NodeHandle private_node) {
        const rovio_sfm::DriveTourNode tour(
            node, rovio_sfm::LoadDriveTourOptions(rovio_sfm::ParametersOf(private_node)));
        rovio_sfm::SpinUntilStopped();
        return tour.HasSucceeded() ? 0 : 1;
      });
}
