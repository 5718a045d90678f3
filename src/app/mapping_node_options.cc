#include "rovio_sfm/app/mapping_node_options.h"

#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/util/log.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool MappingNodeOptions::IsValid(std::string* error) const {
  OptionChecker checker("mapping_node", error);
  checker.Range("number of robots", robots.size(), size_t{1}, size_t{32});
  checker.Range("cloud_period_s", cloud_period_s, 0.1, 60.0);
  checker.Range("drain_s", drain_s, 0.0, 3600.0);
  checker.Range("fetch_timeout_s", fetch_timeout_s, 0.1, 600.0);
  checker.Range("diagnostic_period", diagnostic_period, 0.1, 60.0);
  checker.Nested(mapper);
  if (!checker.Passed()) return false;
  for (const std::string& robot : robots) {
    if (!IsValidRobotName(robot, error)) return false;
  }
  return true;
}

MappingNodeOptions LoadMappingNodeOptions(const YAML::Node& parameters) {
  MappingNodeOptions options;
  OptionReader reader(parameters, "");
  reader.Read("robots", &options.robots);
  reader.Read("output_dir", &options.output_dir);
  reader.Read("overwrite", &options.overwrite);
  reader.Read("cloud_period_s", &options.cloud_period_s);
  reader.Read("drain_s", &options.drain_s);
  reader.Read("fetch_timeout_s", &options.fetch_timeout_s);
  reader.Read("diagnostic_period", &options.diagnostic_period);
  OptionReader mapper = reader.Group("mapper");
  ReadOptions(&mapper, &options.mapper);
  reader.RefuseUnknown();
  RequireValid(options);
  for (const std::string& line : reader.Effective()) LogInfo("option " + line);
  return options;
}

}  // namespace rovio_sfm
