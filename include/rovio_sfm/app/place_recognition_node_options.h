#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/recognition/place_recognizer_options.h"

namespace rovio_sfm {

// The private parameters of the place_recognition node.
struct PlaceRecognitionNodeOptions {
  std::vector<std::string> robots = {"rovio1"};  // whose /<robot>/frames are seen; 1 to 32
  std::string vocabulary;          // file of the place model; empty: the one of the package
  int cache_mb = 256;              // MiB of features kept at hand; 1 to 65536
  double diagnostic_period = 1.0;  // s between two diagnostics; 0.1 to 60
  PlaceRecognizerOptions places;   // group "places": config/place_recognition.yaml
  FrontendOptions frontend;        // group "frontend": how query_image looks at images

  bool IsValid(std::string* error) const;
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit.
PlaceRecognitionNodeOptions LoadPlaceRecognitionNodeOptions(const YAML::Node& parameters);

}  // namespace rovio_sfm
