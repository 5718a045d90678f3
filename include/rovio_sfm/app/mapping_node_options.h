#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rovio_sfm/merging/map_options.h"

namespace rovio_sfm {

// The private parameters of mapping_node.
struct MappingNodeOptions {
  std::vector<std::string> robots = {"rovio1"};  // whose /<robot>/frames are mapped; 1 to 32
  std::string output_dir;        // where maps are written; empty: nothing is, export_map is refused
  bool overwrite = false;        // the map written at the end may replace an older one
  double cloud_period_s = 1.0;   // the cloud goes out no more often; 0.1 to 60
  double drain_s = 10.0;         // at the end, for frames that are queued; 0 to 3600
  double fetch_timeout_s = 5.0;  // missing frames that do not come by then are lost; 0.1 to 600
  double diagnostic_period = 1.0;  // s between two diagnostics; 0.1 to 60
  MapOptions mapper;               // group "mapper": config/mapping.yaml

  bool IsValid(std::string* error) const;
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit.
MappingNodeOptions LoadMappingNodeOptions(const YAML::Node& parameters);

}  // namespace rovio_sfm
