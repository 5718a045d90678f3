#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

enum class F2Method : uint8_t {
  kReprojection = 0,  // the united point must fit every view of both
  kMeanRelative = 1,  // the thesis's test, |a - b| < k |mean| per axis; depends on the origin
};

struct FilterF2Options {
  F2Method method = F2Method::kReprojection;
  double max_chi_square = 9.21;
  double max_relative_distance = 0.1;

  void DescribeOptions(OptionTable& table) {
    bool mean_relative = method == F2Method::kMeanRelative;
    table.AddFlag("mean_relative", mean_relative, "the thesis's test; depends on the origin");
    method = mean_relative ? F2Method::kMeanRelative : F2Method::kReprojection;
    table.AddNumber("max_chi_square", max_chi_square, 1e-6, 1e9, "one view's reprojection: 99 %");
    table.AddNumber("max_relative_distance", max_relative_distance, 1e-6, 1e9, "the thesis's k");
  }
};

// A landmark and its views; vectors of equal length.
struct LandmarkViews {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // in the map
  std::vector<Rigid3> cams_from_map;
  std::vector<Eigen::Vector2d> x_normalized;
  std::vector<double> sigmas;  // of each view, normalised units
};

// The mean of two landmarks, weighted by their number of views - 1 (§3.6, case 6). Both have two
// views at least.
Eigen::Vector3d UnitedPosition(const LandmarkViews& a, const LandmarkViews& b);

// Filter f2 (§3.6): true if both landmarks may be one point.
bool PassesFilterF2(const LandmarkViews& a, const LandmarkViews& b, const FilterF2Options& options);

}  // namespace rovio_sfm
