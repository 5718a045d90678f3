#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace rovio_sfm {

// A pinhole camera with plumb-bob distortion (OpenCV's k1 k2 p1 p2 k3). Pixel (0, 0) is the centre
// of the upper left pixel, x right, y down. "Normalised" points lie on the plane z = 1 of the
// camera, undistorted; all geometry works there (§3.2).
struct Camera {
  double fx = 0.0, fy = 0.0;  // px
  double cx = 0.0, cy = 0.0;  // px
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;
  int width = 0, height = 0;  // px

  // Names the field, its value and what was expected.
  bool IsValid(std::string* error) const;

  double MeanFocal() const { return 0.5 * (fx + fy); }  // px; pixel thresholds are divided by it
};

bool operator==(const Camera& a, const Camera& b);

// The pixel of a normalised point, with distortion.
Eigen::Vector2d PixelFromNormalized(const Camera& camera, const Eigen::Vector2d& x_normalized);

// The normalised point of a pixel, by Newton to 1e-6 px; nothing where the distortion cannot be
// inverted (checked by projecting back to within 1e-3 px).
std::optional<Eigen::Vector2d> NormalizedFromPixel(const Camera& camera,
                                                   const Eigen::Vector2d& x_px);

}  // namespace rovio_sfm
