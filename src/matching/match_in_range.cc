#include "rovio_sfm/matching/match_in_range.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "rovio_sfm/matching/descriptor_distance.h"
#include "rovio_sfm/matching/filter_matches.h"
#include "rovio_sfm/matching/known_matches.h"

namespace rovio_sfm {
namespace {

constexpr double kClearance = 4.0;  // bands from the stretch; nearer may lie the same point again

struct Candidate {
  uint32_t index = 0;
  Eigen::Vector2d x_normalized;
};

// Where a feature of b may lie in a.
struct Stretch {
  Eigen::Vector2d begin, direction;  // direction of length 1, or 0
  double length = 0.0;

  double DistanceTo(const Eigen::Vector2d& x) const {
    const Eigen::Vector2d offset = x - begin;
    return (offset - std::clamp(offset.dot(direction), 0.0, length) * direction).norm();
  }

  double LeastY() const { return std::min(begin.y(), begin.y() + length * direction.y()); }
  double GreatestY() const { return std::max(begin.y(), begin.y() + length * direction.y()); }
};

std::optional<Stretch> StretchOf(const Eigen::Vector2d& x_in_b, const DepthRange& range,
                                 const Rigid3& a_from_b) {
  if (!(range.far > 0.0)) return std::nullopt;
  const Eigen::Vector3d ray = x_in_b.homogeneous();
  const Eigen::Vector3d near = a_from_b * (range.near * ray), far = a_from_b * (range.far * ray);
  if (!(near.z() > 0.0) || !(far.z() > 0.0)) return std::nullopt;
  Stretch stretch{near.hnormalized(), far.hnormalized() - near.hnormalized(), 0.0};
  stretch.length = stretch.direction.norm();
  stretch.direction = stretch.length > 0.0 ? Eigen::Vector2d(stretch.direction / stretch.length)
                                           : Eigen::Vector2d::Zero();
  return stretch;
}

// From the least y on.
std::vector<Candidate> FreeFeatures(const FrameFeatures& a,
                                    const std::vector<FeatureMatch>& known) {
  const std::vector<bool> used = UsedFeatures(a.keypoints.size(), known, &FeatureMatch::a);
  std::vector<Candidate> free;
  for (uint32_t i = 0; i < a.keypoints.size(); ++i) {
    if (!used[i]) free.push_back({i, a.keypoints[i].x_normalized});
  }
  std::sort(free.begin(), free.end(), [](const Candidate& one, const Candidate& other) {
    return std::make_pair(one.x_normalized.y(), one.index) <
           std::make_pair(other.x_normalized.y(), other.index);
  });
  return free;
}

struct Search {
  const Descriptors& a;
  const Descriptors& b;
  const std::vector<Candidate>& free;  // from the least y on
  double band = 0.0;                   // on the plane z = 1
  float max_distance = 0.0f;
  const RangeMatchOptions& options;
};

// Whether a feature of the sample looks about as much like b's as the best of its stretch does.
bool LooksLikeElsewhere(const Search& search, const Stretch& stretch, const FeatureMatch& best) {
  const auto step = static_cast<size_t>(search.options.sample_step);
  for (size_t i = 0; step > 0 && i < search.free.size(); i += step) {
    const Candidate& candidate = search.free[i];
    if (stretch.DistanceTo(candidate.x_normalized) <= kClearance * search.band) continue;
    const float distance = DescriptorDistance(search.a, candidate.index, search.b, best.b);
    if (best.distance > search.options.max_sample_ratio * distance) return true;
  }
  return false;
}

// Of equally near ones the first.
std::optional<FeatureMatch> FindInStretch(const Search& search, const Stretch& stretch,
                                          uint32_t index_b) {
  FeatureMatch best{UINT32_MAX, index_b, std::numeric_limits<float>::infinity(), 1.0f};
  float second = std::numeric_limits<float>::infinity();
  const auto is_above = [](const Candidate& candidate, double y) {
    return candidate.x_normalized.y() < y;
  };
  const double least_y = stretch.LeastY() - search.band;
  const double greatest_y = stretch.GreatestY() + search.band;
  auto at = std::lower_bound(search.free.begin(), search.free.end(), least_y, is_above);
  for (; at != search.free.end() && at->x_normalized.y() <= greatest_y; ++at) {
    if (stretch.DistanceTo(at->x_normalized) > search.band) continue;
    const float distance = DescriptorDistance(search.a, at->index, search.b, index_b);
    second = std::min(second, std::max(distance, best.distance));
    if (std::make_pair(distance, at->index) < std::make_pair(best.distance, best.a)) {
      best.a = at->index, best.distance = distance;
    }
  }
  if (!(best.distance <= search.max_distance)) return std::nullopt;
  if (best.distance > search.options.max_ratio * second) return std::nullopt;
  if (LooksLikeElsewhere(search, stretch, best)) return std::nullopt;
  best.ratio = best.distance / second;  // 0 where it is alone
  return best;
}

}  // namespace

std::vector<FeatureMatch> MatchInRange(const FrameFeatures& a, const FrameFeatures& b,
                                       const Rigid3& b_from_a,
                                       const std::vector<DepthRange>& ranges_in_b,
                                       const std::vector<FeatureMatch>& known, double focal_px,
                                       const RangeMatchOptions& options) {
  if (known.empty() || !AreComparable(a.descriptors, b.descriptors)) return {};
  const std::vector<Candidate> free = FreeFeatures(a, known);
  const Search search{a.descriptors,
                      b.descriptors,
                      free,
                      options.band_px / focal_px,
                      options.max_factor * MeanDistance(known),
                      options};
  const Rigid3 a_from_b = Inverse(b_from_a);
  const std::vector<bool> used_b = UsedFeatures(b.keypoints.size(), known, &FeatureMatch::b);
  std::vector<FeatureMatch> found;
  for (uint32_t i = 0; i < b.keypoints.size(); ++i) {
    if (used_b[i]) continue;
    const auto stretch = StretchOf(b.keypoints[i].x_normalized, ranges_in_b[i], a_from_b);
    if (!stretch) continue;
    if (const auto match = FindInStretch(search, *stretch, i)) found.push_back(*match);
  }
  return FilterOneToOne(found);
}

}  // namespace rovio_sfm
