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

// The same lens by another calibration: focal lengths that are correction[0] larger (a share), the
// centre shifted by correction[1] of fx and correction[2] of fy.
Camera CorrectedCamera(const Camera& camera, const Eigen::Vector3d& correction);
// The correction that makes `corrected` of `camera`.
Eigen::Vector3d CorrectionOf(const Camera& camera, const Camera& corrected);

// The pixel of a normalised point, with distortion.
Eigen::Vector2d PixelFromNormalized(const Camera& camera, const Eigen::Vector2d& x_normalized);

// The normalised point of a pixel, by Newton to 1e-6 px; nothing where the distortion cannot be
// inverted (checked by projecting back to within 1e-3 px).
std::optional<Eigen::Vector2d> NormalizedFromPixel(const Camera& camera,
                                                   const Eigen::Vector2d& x_px);

// How the normalised point of a pixel moves with a correction of its camera, to first order.
Eigen::Matrix<double, 2, 3> NormalizedByCorrection(const Camera& camera,
                                                   const Eigen::Vector2d& x_normalized);

}  // namespace rovio_sfm
