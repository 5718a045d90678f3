#include "rovio_sfm/app/place_recognition_node_options.h"

#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/util/log.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool PlaceRecognitionNodeOptions::IsValid(std::string* error) const {
  OptionChecker checker("place_recognition_node", error);
  checker.Range("number of robots", robots.size(), size_t{1}, size_t{32});
  checker.Range("cache_mb", cache_mb, 1, 65536);
  checker.Range("diagnostic_period", diagnostic_period, 0.1, 60.0);
  checker.Nested(places);
  checker.Nested(frontend);
  if (!checker.Passed()) return false;
  for (const std::string& robot : robots) {
    if (!IsValidRobotName(robot, error)) return false;
  }
  return true;
}

PlaceRecognitionNodeOptions LoadPlaceRecognitionNodeOptions(const YAML::Node& parameters) {
  PlaceRecognitionNodeOptions options;
  OptionReader reader(parameters, "");
  reader.Read("robots", &options.robots);
  reader.Read("vocabulary", &options.vocabulary);
  reader.Read("cache_mb", &options.cache_mb);
  reader.Read("diagnostic_period", &options.diagnostic_period);
  OptionReader places = reader.Group("places");
  ReadOptions(&places, &options.places);
  OptionReader frontend = reader.Group("frontend");
  ReadOptions(&frontend, &options.frontend);
  reader.RefuseUnknown();
  RequireValid(options);
  for (const std::string& line : reader.Effective()) LogInfo("option " + line);
  return options;
}

}  // namespace rovio_sfm
