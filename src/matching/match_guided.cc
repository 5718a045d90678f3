#include "rovio_sfm/matching/match_guided.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rovio_sfm/matching/descriptor_distance.h"
#include "rovio_sfm/matching/filter_matches.h"
#include "rovio_sfm/matching/known_matches.h"

namespace rovio_sfm {
namespace {

// A feature of a as seen from b: its epipolar line (unit normal) and its direction (point at
// infinity, not normalised).
struct Ray {
  uint32_t index = 0;
  Eigen::Vector3d line_in_b;
  Eigen::Vector3d direction_in_b;
};

std::vector<Ray> FreeRays(const FrameFeatures& a, const Rigid3& b_from_a,
                          const std::vector<bool>& used) {
  std::vector<Ray> rays;
  for (uint32_t i = 0; i < a.keypoints.size(); ++i) {
    if (used[i]) continue;
    Ray ray{i, {}, b_from_a.rotation * a.keypoints[i].x_normalized.homogeneous()};
    ray.line_in_b = b_from_a.translation.cross(ray.direction_in_b);
    const double norm = ray.line_in_b.head<2>().norm();
    if (norm < 1e-9) continue;  // the epipole itself: no line
    ray.line_in_b /= norm;
    rays.push_back(ray);
  }
  return rays;
}

// True if the point of the band is no nearer than allowed and lies in front of both cameras.
bool IsDepthPossible(const Ray& ray, const Eigen::Vector3d& x_in_b,
                     const Eigen::Vector3d& translation, double band, double min_depth) {
  const Eigen::Vector3d across = x_in_b.cross(ray.direction_in_b);
  if (across.norm() < band * ray.direction_in_b.norm()) return true;  // at infinity
  const double depth_in_a = -x_in_b.cross(translation).dot(across) / across.squaredNorm();
  const double depth_in_b = depth_in_a * ray.direction_in_b.z() + translation.z();
  return depth_in_a >= min_depth && depth_in_b > 0.0;
}

struct Search {
  const FrameFeatures& a;
  const FrameFeatures& b;
  const std::vector<Ray>& rays;
  Eigen::Vector3d translation;
  double band = 0.0;  // on the plane z = 1
  float max_distance = 0.0f;
  const GuidedOptions& options;
};

// The nearest feature of the band, if it is near enough and clearly nearer than the second.
std::optional<FeatureMatch> FindInBand(const Search& search, uint32_t index_b) {
  const Eigen::Vector3d x_in_b = search.b.keypoints[index_b].x_normalized.homogeneous();
  FeatureMatch best{0, index_b, std::numeric_limits<float>::infinity(), 1.0f};
  float second = std::numeric_limits<float>::infinity();
  for (const Ray& ray : search.rays) {
    if (std::abs(ray.line_in_b.dot(x_in_b)) > search.band) continue;
    if (!IsDepthPossible(ray, x_in_b, search.translation, search.band,
                         search.options.min_depth_baselines)) {
      continue;
    }
    const float distance =
        DescriptorDistance(search.a.descriptors, ray.index, search.b.descriptors, index_b);
    second = std::min(second, std::max(distance, best.distance));
    if (distance < best.distance) {
      best.a = ray.index;
      best.distance = distance;
    }
  }
  if (!(best.distance <= search.max_distance)) return std::nullopt;
  if (best.distance > search.options.max_ratio * second) return std::nullopt;
  best.ratio = std::isfinite(second) ? best.distance / second : search.options.max_ratio;
  return best;
}

}  // namespace

std::vector<FeatureMatch> MatchGuided(const FrameFeatures& a, const FrameFeatures& b,
                                      const Rigid3& b_from_a,
                                      const std::vector<FeatureMatch>& known, double focal_px,
                                      const GuidedOptions& options) {
  if (known.empty() || b_from_a.translation.norm() < 1e-9) return {};
  if (a.descriptors.type != b.descriptors.type || a.descriptors.length != b.descriptors.length) {
    return {};
  }
  const std::vector<Ray> rays =
      FreeRays(a, b_from_a, UsedFeatures(a.keypoints.size(), known, &FeatureMatch::a));
  const Search search{a,
                      b,
                      rays,
                      b_from_a.translation.normalized(),
                      options.band_px / focal_px,
                      options.max_factor * MeanDistance(known),
                      options};
  const std::vector<bool> used_b = UsedFeatures(b.keypoints.size(), known, &FeatureMatch::b);
  std::vector<FeatureMatch> found;
  for (uint32_t index_b = 0; index_b < b.keypoints.size(); ++index_b) {
    if (used_b[index_b]) continue;
    if (const auto match = FindInBand(search, index_b)) found.push_back(*match);
  }
  return FilterOneToOne(found);
}

}  // namespace rovio_sfm
