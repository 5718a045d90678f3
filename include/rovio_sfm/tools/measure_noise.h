#pragma once

#include <array>
#include <filesystem>
#include <iosfwd>
#include <vector>

namespace rovio_sfm {

// Noise of a camera, in grey levels of 0 to 255 (§3.1.1).
struct NoiseReport {
  size_t num_pictures = 0;
  std::array<double, 3> sigma_bgr{};  // of one pixel over the pictures, per channel
  double sigma = 0.0;                 // root mean square of the three
  double clipped_share = 0.0;  // of the values within 3 levels of 0 or 255: noise is hidden there
};

// The noise from at least two pictures of one flat, single-coloured surface by a resting camera:
// the spread of each pixel around its mean over the pictures, after each picture's mean brightness
// is removed. Unreadable pictures are left out and named on the log. Throws std::runtime_error for
// mixed sizes or too few pictures.
NoiseReport MeasureNoise(const std::vector<std::filesystem::path>& images);

// The command measure_noise. Returns the exit status.
int MeasureNoiseCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
