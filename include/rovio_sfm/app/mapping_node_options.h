#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rovio_sfm/app/robot_names.h"
#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The private parameters of mapping_node.
struct MappingNodeOptions {
  std::vector<std::string> robots = {"rovio1"};
  std::string output_dir;
  bool overwrite = false;
  bool keep_store = true;
  bool keep_images = true;
  bool localize = false;
  double cloud_period_s = 1.0;
  double drain_s = 5.0;
  double fetch_timeout_s = 5.0;
  double diagnostic_period = 1.0;
  MapOptions mapper;

  void DescribeOptions(OptionTable& table) {
    AddRobotNames(table, robots, "whose /<robot>/frames are mapped");
    table.AddText("output_dir", output_dir,
                  "of maps, absolute or below ~; empty: a dated one in $ROS_HOME/rovio_sfm");
    table.AddFlag("overwrite", overwrite, "the map written at the end may replace an older one");
    table.AddFlag("keep_store", keep_store, "maps are kept in output_dir/map.db and go on");
    table.AddFlag("localize", localize,
                  "robots are posed in the maps of output_dir/map.db, which stay what they are");
    table.AddFlag("keep_images", keep_images, "the store keeps the JPEGs that frames bring");
    table.AddNumber("cloud_period_s", cloud_period_s, 0.1, 60.0, "the cloud goes out no oftener");
    table.AddNumber("drain_s", drain_s, 0.0, 3600.0, "at the end, for frames that are queued");
    table.AddNumber("fetch_timeout_s", fetch_timeout_s, 0.1, 600.0, "missing frames are lost then");
    table.AddNumber("diagnostic_period", diagnostic_period, 0.1, 60.0, "s between two diagnostics");
    table.AddGroup("mapper", mapper, "config/mapping.yaml");
  }
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit.
MappingNodeOptions LoadMappingNodeOptions(const YAML::Node& parameters);

}  // namespace rovio_sfm
