#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/landmark_limits.h"

namespace rovio_sfm {

// A view of a point: where and how well it is seen.
struct PointView {
  Rigid3 cam_from_map;
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();
  double sigma = 1.0;
};

struct TriangulatedPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::vector<uint32_t> inliers;  // into the views, ascending, two at least
};

// The point that most views agree on: hypotheses from pairs of views, the widest apart first, then
// Linear-Eigen over the agreeing views (A.6.1) and Gauss-Newton. A bad view costs the view, not the
// point. Nothing where no two views agree, the parallax is small, or the point is behind a view.
std::optional<TriangulatedPoint> TriangulatePoint(const std::vector<PointView>& views,
                                                  const LandmarkLimits& limits);

struct TriangulateReport {
  uint32_t num_created = 0;    // new landmarks
  uint32_t num_completed = 0;  // observations added to landmarks that were there
};

// Adds the members of the frame's tracks to the landmarks they agree with; returns how many.
uint32_t CompleteLandmarks(uint32_t frame, double max_error_sigmas, Session* session);

// Gives landmarks to the frame's tracks that have none and can be triangulated from frames that are
// not weak, then completes all of the frame's landmarks.
TriangulateReport TriangulateTracks(uint32_t frame, const LandmarkLimits& limits, Session* session);

}  // namespace rovio_sfm
