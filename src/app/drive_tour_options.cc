#include "rovio_sfm/app/drive_tour_options.h"

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {

DriveTourOptions LoadDriveTourOptions(const YAML::Node& parameters) {
  DriveTourOptions options;
  LogOptions(LoadOptions(parameters, "drive_tour", &options));
  return options;
}

}  // namespace rovio_sfm
