#include "rovio_sfm/app/driver_credentials.h"
#include "rovio_sfm/ros/rovio_driver_node.h"
#include "rovio_sfm/ros/run_node.h"

int main(int argc, char** argv) {
  return rovio_sfm::RunNode(
      argc, argv, "rovio_driver", [](ros::NodeHandle node, ros::NodeHandle private_node) {
        const auto options = rovio_sfm::LoadDriverOptions(node, private_node);
        rovio_sfm::RovioDriverNode driver(node, private_node, options,
                                          rovio_sfm::LoadCredentials(options.credentials_file));
        rovio_sfm::SpinUntilStopped();
        return 0;
      });
}
