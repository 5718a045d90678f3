#include "rovio_sfm/matching/match_guided.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/flann.hpp>

namespace rovio_sfm {
namespace {

constexpr double kMinInverseDepth = 1e-6;  // of baselines: as good as at infinity

cv::Mat PlaceRow(const Keypoint& keypoint) {
  return (cv::Mat_<float>(1, 2) << static_cast<float>(keypoint.x_normalized.x()),
          static_cast<float>(keypoint.x_normalized.y()));
}

// Of a match's point in b; 0 at infinity, below it where the rays diverge.
double InverseDepth(const Eigen::Vector2d& x_in_a, const Eigen::Vector2d& x_in_b,
                    const Rigid3& b_from_a) {
  const Eigen::Vector3d ray = x_in_b.homogeneous();
  const Eigen::Vector3d direction = b_from_a.rotation * x_in_a.homogeneous();
  // Crossed with the direction, depth · ray = translation + depth in a · direction loses its end.
  const Eigen::Vector3d across = direction.cross(ray),
                        offset = direction.cross(b_from_a.translation);
  return across.dot(offset) / offset.squaredNorm();
}

// The nearest known matches of each feature of b: indices into known.
cv::Mat1i NearestKnown(const FrameFeatures& b, const std::vector<FeatureMatch>& known, int count) {
  cv::Mat1f places(0, 2), queries(0, 2);
  for (const FeatureMatch& match : known) places.push_back(PlaceRow(b.keypoints[match.b]));
  for (const Keypoint& keypoint : b.keypoints) queries.push_back(PlaceRow(keypoint));
  cv::flann::GenericIndex<cvflann::L2_Simple<float>> index(places,
                                                           cvflann::KDTreeSingleIndexParams());
  cv::Mat1i nearest(queries.rows, count);
  cv::Mat1f distances(queries.rows, count);
  index.knnSearch(queries, nearest, distances, count,
                  cvflann::SearchParams(cvflann::FLANN_CHECKS_UNLIMITED));
  return nearest;
}

// By feature of b, in baselines.
std::vector<DepthRange> DepthsAround(const FrameFeatures& a, const FrameFeatures& b,
                                     const Rigid3& b_from_a, const std::vector<FeatureMatch>& known,
                                     double band, const GuidedOptions& options) {
  std::vector<double> inverse_depths;
  for (const FeatureMatch& match : known) {
    inverse_depths.push_back(InverseDepth(a.keypoints[match.a].x_normalized,
                                          b.keypoints[match.b].x_normalized, b_from_a));
  }
  const int count = std::min(options.neighbors, static_cast<int>(known.size()));
  const cv::Mat1i nearest = NearestKnown(b, known, count);
  std::vector<DepthRange> ranges;
  for (int i = 0; i < nearest.rows; ++i) {
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (int j = 0; j < count; ++j) {
      const double inverse_depth = inverse_depths[static_cast<size_t>(nearest(i, j))];
      least = std::min(least, inverse_depth);
      greatest = std::max(greatest, inverse_depth);
    }
    const double far = std::max(least / options.max_depth_ratio - band, kMinInverseDepth);
    const double near = std::max(greatest * options.max_depth_ratio + band, kMinInverseDepth);
    ranges.push_back({1.0 / near, 1.0 / far});
  }
  return ranges;
}

}  // namespace

std::vector<FeatureMatch> MatchGuided(const FrameFeatures& a, const FrameFeatures& b,
                                      const Rigid3& b_from_a,
                                      const std::vector<FeatureMatch>& known, double focal_px,
                                      const GuidedOptions& options) {
  if (known.empty() || b_from_a.translation.norm() < 1e-9) return {};
  const Rigid3 unit{b_from_a.rotation, b_from_a.translation.normalized()};
  RangeMatchOptions range = options.range;
  if (known.size() < static_cast<size_t>(options.few_known)) range.max_factor = options.few_factor;
  const double band = range.band_px / focal_px;
  return MatchInRange(a, b, unit, DepthsAround(a, b, unit, known, band, options), known, focal_px,
                      range);
}

}  // namespace rovio_sfm
