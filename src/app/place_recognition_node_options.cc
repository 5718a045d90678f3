#include "rovio_sfm/app/place_recognition_node_options.h"

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {

PlaceRecognitionNodeOptions LoadPlaceRecognitionNodeOptions(const YAML::Node& parameters) {
  PlaceRecognitionNodeOptions options;
  LogOptions(LoadOptions(parameters, "", &options));
  return options;
}

}  // namespace rovio_sfm
