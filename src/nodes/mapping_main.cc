#include <ros/console.h>

#include <filesystem>
#include <system_error>

#include "rovio_sfm/app/output_folder.h"
#include "rovio_sfm/ros/mapping_node.h"
#include "rovio_sfm/ros/run_node.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kLeastFreeBytes = 10u << 20;

int Map(ros::NodeHandle node, ros::NodeHandle private_node) {
  MappingNodeOptions options = LoadMappingNodeOptions(ParametersOf(private_node));
  options.output_dir =
      NodeOutputFolder("output_dir", options.output_dir, CurrentOutputPlace()).string();
  if (!options.localize) RequireWritableFolder(options.output_dir, kLeastFreeBytes);
  ROS_INFO_STREAM((options.localize ? "maps are those of " : "maps go to ") << options.output_dir);
  MappingNode mapping(options, node, private_node);
  SpinUntilStopped([&] { mapping.Tick(); });
  const bool is_written = mapping.End();
  std::error_code ignored;
  std::filesystem::remove(options.output_dir, ignored);  // where nothing was written into it
  return is_written ? 0 : 1;
}

}  // namespace
}  // namespace rovio_sfm

int main(int argc, char** argv) {
  return rovio_sfm::RunNode(argc, argv, "mapping", rovio_sfm::Map);
}
