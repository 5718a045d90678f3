#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rovio_sfm/app/robot_names.h"
#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/recognition/place_recognizer_options.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The private parameters of the place_recognition node.
struct PlaceRecognitionNodeOptions {
  std::vector<std::string> robots = {"rovio1"};
  std::string vocabulary;
  int cache_mb = 256;
  double diagnostic_period = 1.0;
  PlaceRecognizerOptions places;
  FrontendOptions frontend;

  void DescribeOptions(OptionTable& table) {
    AddRobotNames(table, robots, "whose /<robot>/frames are seen");
    table.AddText("vocabulary", vocabulary, "file of the place model; empty: the package's");
    table.AddNumber("cache_mb", cache_mb, 1, 65536, "of features kept at hand");
    table.AddNumber("diagnostic_period", diagnostic_period, 0.1, 60.0, "s between two diagnostics");
    table.AddGroup("places", places, "config/place_recognition.yaml");
    table.AddGroup("frontend", frontend, "how query_image looks at images: config/frontend.yaml");
  }
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit.
PlaceRecognitionNodeOptions LoadPlaceRecognitionNodeOptions(const YAML::Node& parameters);

}  // namespace rovio_sfm
