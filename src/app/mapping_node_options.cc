#include "rovio_sfm/app/mapping_node_options.h"

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {

MappingNodeOptions LoadMappingNodeOptions(const YAML::Node& parameters) {
  MappingNodeOptions options;
  LogOptions(LoadOptions(parameters, "", &options));
  return options;
}

}  // namespace rovio_sfm
