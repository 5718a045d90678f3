#include "rovio_sfm/app/frontend_node_options.h"

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {

FrontendNodeOptions LoadFrontendNodeOptions(const YAML::Node& parameters,
                                            const std::string& name_space) {
  FrontendNodeOptions options;
  options.robot = name_space.substr(name_space.find_last_of('/') + 1);
  YAML::Node known = YAML::Clone(parameters);
  known.remove("thresholds");  // what dynamic_reconfigure left there; stands again in "frontend"
  LogOptions(LoadOptions(known, "", &options));
  if (options.sensors.base_frame.empty()) options.sensors.base_frame = options.robot + "/base_link";
  return options;
}

}  // namespace rovio_sfm
