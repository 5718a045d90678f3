#include "rovio_sfm/app/frontend_node_options.h"

#include <filesystem>
#include <stdexcept>

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {

FrontendNodeOptions LoadFrontendNodeOptions(const YAML::Node& parameters,
                                            const std::string& name_space) {
  FrontendNodeOptions options;
  options.robot = name_space.substr(name_space.find_last_of('/') + 1);
  YAML::Node known = YAML::Clone(parameters);
  known.remove("thresholds");  // what dynamic_reconfigure left there; stands again in "frontend"
  LogOptions(LoadOptions(known, "", &options));
  const std::string& file = options.calibration_file;
  if (!file.empty() && !std::filesystem::path(file).is_absolute()) {
    throw std::runtime_error("calibration_file: '" + file + "': expected an absolute path");
  }
  if (options.sensors.base_frame.empty()) options.sensors.base_frame = options.robot + "/base_link";
  return options;
}

}  // namespace rovio_sfm
