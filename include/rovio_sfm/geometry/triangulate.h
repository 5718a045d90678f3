#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// The point seen at x_normalized[i] by the camera cams_from_map[i], by the Linear-Eigen method over
// all views (A.6.1), in the map's frame. Nothing for fewer than two views, unequal counts, cameras
// in one place, parallel rays, rays along the baseline, or a point behind one of the cameras.
std::optional<Eigen::Vector3d> TriangulateLinear(const std::vector<Rigid3>& cams_from_map,
                                                 const std::vector<Eigen::Vector2d>& x_normalized);

// Up to num_steps Gauss-Newton steps on the squared reprojection error, from point_in_map; a step
// that raises the error is not taken. Nothing if the point is behind a camera or the views do not
// determine it.
std::optional<Eigen::Vector3d> RefinePoint(const std::vector<Rigid3>& cams_from_map,
                                           const std::vector<Eigen::Vector2d>& x_normalized,
                                           const Eigen::Vector3d& point_in_map, int num_steps = 3);

// The angle in rad, in [0, pi], under which the two camera centres are seen from the point.
double ParallaxAngle(const Eigen::Vector3d& center_a, const Eigen::Vector3d& center_b,
                     const Eigen::Vector3d& point);

// The distance on the plane z = 1 between the projected point and where it was seen; times the
// focal length it is in pixels. Nothing if the point is not in front of the camera.
std::optional<double> ReprojectionError(const Rigid3& cam_from_map,
                                        const Eigen::Vector2d& x_normalized,
                                        const Eigen::Vector3d& point_in_map);

}  // namespace rovio_sfm
