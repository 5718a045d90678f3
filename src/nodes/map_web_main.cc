#include <random>
#include <sstream>

#include "rovio_sfm/ros/map_web_node.h"
#include "rovio_sfm/ros/run_node.h"

namespace {

// 128 bits as 32 hexadecimal digits.
std::string RandomText() {
  std::random_device source;
  std::ostringstream text;
  for (int i = 0; i < 32; ++i) text << std::hex << (source() & 15u);
  return text.str();
}

}  // namespace

int main(int argc, char** argv) {
  return rovio_sfm::RunNode(
      argc, argv, "map_web", [](ros::NodeHandle node, ros::NodeHandle private_node) {
        const auto options = rovio_sfm::LoadMapWebOptions(rovio_sfm::ParametersOf(private_node));
        rovio_sfm::MapWebNode web(options, RandomText(), node);
        rovio_sfm::SpinUntilStopped([&web] { web.Tick(); });
        return 0;
      });
}
