#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/sim/robot/omni_wheels.h"
#include "rovio_sfm/sim/world/develop_image.h"
#include "rovio_sfm/sim/world/render_image.h"

namespace rovio_sfm::sim {

struct RenderTourOptions {
  std::string config_folder;  // holds worlds/ and tours/
  std::string tour;           // name of a file in tours/, without .yaml
  std::string out_folder;     // made if missing; refused if it holds images and overwrite is false
  std::string clean_out_folder;  // if not empty: the same tour without noise, at almost no cost
  bool overwrite = false;
  uint64_t seed = 1;
  int max_frames = 0;       // only the first so many; 0 means all
  uint64_t light = 0;       // of InLight
  double steps = 1.0;       // of WithLongerSteps, 0.1 … 10
  bool has_movers = false;  // those of the tour walk
  // calibration.txt is what a calibration finds, calibration_true.txt what pictures were made with;
  // else calibration.txt is true.
  bool errs_in_calibration = false;
  int num_threads = 1;  // 1 … 64; the bytes do not depend on it
  RenderOptions render;
  DevelopOptions develop;
  SlipOptions slip;

  bool IsValid(std::string* error) const;
};

// Renders a tour into a folder laid out as data.md says (images, times, calibration, ground truth,
// odometry, extrinsics, overlaps). Throws std::runtime_error that names what is wrong. Returns the
// number of pictures.
int RenderTour(const RenderTourOptions& options);

// Writes what the tour's pictures see of the true surfaces (SampleSurface) as the file out_folder;
// refuses one that is there unless overwrite. Throws as RenderTour. Returns the number of points.
size_t WriteTourSurface(const RenderTourOptions& options);

}  // namespace rovio_sfm::sim
