#include "rovio_sfm/tracks/filter_f2.h"

#include <limits>

#include "rovio_sfm/geometry/triangulate.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

bool FitsAllViews(const Eigen::Vector3d& position, const LandmarkViews& landmark,
                  double max_chi_square) {
  for (size_t i = 0; i < landmark.cams_from_map.size(); ++i) {
    const auto error =
        ReprojectionError(landmark.cams_from_map[i], landmark.x_normalized[i], position);
    if (!error) return false;
    const double sigmas = *error / landmark.sigmas[i];
    if (!(sigmas * sigmas <= max_chi_square)) return false;
  }
  return true;
}

// |a - b| < k |mean(a, b)| for each axis, as printed in the thesis.
bool IsNearRelativeToMean(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double factor) {
  const Eigen::Array3d limit = factor * 0.5 * (a + b).array().abs();
  return ((a - b).array().abs() < limit).all();
}

double Weight(const LandmarkViews& landmark) {
  return static_cast<double>(landmark.cams_from_map.size()) - 1.0;
}

}  // namespace

Eigen::Vector3d UnitedPosition(const LandmarkViews& a, const LandmarkViews& b) {
  ROVIO_CHECK(a.cams_from_map.size() >= 2 && b.cams_from_map.size() >= 2);
  return (Weight(a) * a.position + Weight(b) * b.position) / (Weight(a) + Weight(b));
}

bool PassesFilterF2(const LandmarkViews& a, const LandmarkViews& b,
                    const FilterF2Options& options) {
  if (options.method == F2Method::kMeanRelative) {
    return IsNearRelativeToMean(a.position, b.position, options.max_relative_distance);
  }
  const Eigen::Vector3d united = UnitedPosition(a, b);
  return FitsAllViews(united, a, options.max_chi_square) &&
         FitsAllViews(united, b, options.max_chi_square);
}

}  // namespace rovio_sfm
