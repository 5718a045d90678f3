#pragma once

#include "rovio_sfm/app/option_reader.h"
#include "rovio_sfm/app/sensor_options.h"
#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/matching/match_pair.h"
#include "rovio_sfm/merging/map_options.h"
#include "rovio_sfm/recognition/place_recognizer_options.h"

// Options from YAML (files or parameters), field by field as the structs have them. An unknown key,
// a value of another type or out of range throws std::runtime_error that names it: a node then does
// not start.
namespace rovio_sfm {

void ReadOptions(OptionReader* reader, FrontendOptions* options);         // config/frontend.yaml
void ReadOptions(OptionReader* reader, MapOptions* options);              // config/mapping.yaml
void ReadOptions(OptionReader* reader, PlaceRecognizerOptions* options);  // place_recognition.yaml
void ReadOptions(OptionReader* reader, SensorOptions* options);
void ReadOptions(OptionReader* reader, PairOptions* options);   // a group of several
void ReadOptions(OptionReader* reader, MergeOptions* options);  // a group of config/mapping.yaml

// Throws what IsValid complains about.
template <typename Options>
void RequireValid(const Options& options) {
  std::string error;
  if (!options.IsValid(&error)) throw std::runtime_error(error);
}

}  // namespace rovio_sfm
