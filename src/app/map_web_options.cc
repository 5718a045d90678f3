#include "rovio_sfm/app/map_web_options.h"

#include <algorithm>

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {

MapWebOptions LoadMapWebOptions(const YAML::Node& parameters) {
  MapWebOptions options;
  std::vector<std::string> effective = LoadOptions(parameters, "map_web", &options);
  const auto is_token = [](const std::string& line) {
    return line.compare(0, 14, "map_web.token ") == 0;
  };
  effective.erase(std::remove_if(effective.begin(), effective.end(), is_token), effective.end());
  LogOptions(effective);
  return options;
}

}  // namespace rovio_sfm
