#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "rovio_sfm/sim/tour/simulate_tour.h"
#include "rovio_sfm/sim/world/develop_image.h"
#include "rovio_sfm/sim/world/render_image.h"

namespace rovio_sfm::sim {

// A point of the true surface that a tour sees.
struct SurfaceSample {
  Eigen::Vector3f x_in_world = Eigen::Vector3f::Zero();  // m
  std::array<uint8_t, 3> color{};                        // RGB, of the first picture that sees it
  float contrast = 0.0f;   // standard deviation in 9 x 9 px, grey levels, mean of the pictures
  uint32_t num_views = 0;  // pictures that see it
  // How far an error of 1 px in each of them moves it along its worst direction; infinite of one.
  float sigma_m = std::numeric_limits<float>::infinity();
  int32_t object = -1;  // index into the world's objects, or -1 for a lamp
};

struct SampleSurfaceOptions {
  double spacing_m = 0.02;  // one sample in each cube of this edge, above 0
  int step_px = 2;          // rays are cast at every so many pixels, above 0
  double depth_limit_m = 30.0;
};

// What the pictures of a tour, without noise, see of the surfaces, by place.
std::vector<SurfaceSample> SampleSurface(const ImageRenderer& renderer, const SimulatedTour& tour,
                                         const DevelopOptions& develop,
                                         const SampleSurfaceOptions& options);

// The bytes of a binary little-endian PLY: x y z red green blue contrast views sigma object; a
// comment "object INDEX NAME" for each object of the world.
std::string SurfacePlyBytes(const std::vector<SurfaceSample>& samples, const WorldSpec& world);

}  // namespace rovio_sfm::sim
