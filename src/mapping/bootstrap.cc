#include "rovio_sfm/mapping/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "rovio_sfm/geometry/triangulate.h"
#include "rovio_sfm/matching/verify_pair.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr int kMinSamples = 500;
constexpr size_t kMaxOfBest = 20;       // frames of which all pairs are tested at a drive's end
constexpr size_t kMaxFirstFrames = 10;  // tested per new frame, spread evenly over those held

std::vector<Eigen::Vector2d> PointsOf(const FrameEvent& event) {
  std::vector<Eigen::Vector2d> points;
  for (const Keypoint& keypoint : event.features->keypoints) {
    points.push_back(keypoint.x_normalized);
  }
  return points;
}

std::vector<FeatureMatch> CommonTracks(const FrameEvent& first, const FrameEvent& second,
                                       const Session& aliases) {
  std::unordered_map<TrackId, uint32_t> features;  // look-up only
  for (uint32_t i = 0; i < first.tracks.size(); ++i) {
    if (first.tracks[i] != 0) features.emplace(aliases.RootOf(first.tracks[i]), i);
  }
  std::vector<FeatureMatch> matches;
  for (uint32_t i = 0; i < second.tracks.size(); ++i) {
    if (second.tracks[i] == 0) continue;
    const auto it = features.find(aliases.RootOf(second.tracks[i]));
    if (it != features.end()) matches.push_back({it->second, i, 0.0f, 1.0f});
  }
  return matches;
}

// Matches along tracks are nearly all right, so RANSAC would end after a few samples; but in front
// of few planes a wrong motion explains four fifths of them, and one sample may lead there.
VerifyPairOptions SearchThoroughly() {
  VerifyPairOptions options;
  options.min_iterations = kMinSamples;
  options.prosac_samples = 0;
  return options;
}

// The median angle of the pair's widest min_inliers points.
double WideAngle(const std::vector<Eigen::Vector2d>& points_a,
                 const std::vector<Eigen::Vector2d>& points_b,
                 const std::vector<FeatureMatch>& matches, const PairVerification& pair,
                 size_t min_inliers) {
  std::vector<double> angles;
  for (const uint32_t i : pair.inliers) {
    const auto point = TriangulateLinear({Rigid3{}, pair.cam_b_from_cam_a},
                                         {points_a[matches[i].a], points_b[matches[i].b]});
    if (!point) continue;
    angles.push_back(
        ParallaxAngle(Eigen::Vector3d::Zero(), OriginInA(pair.cam_b_from_cam_a), *point));
  }
  if (angles.size() < min_inliers) return 0.0;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(min_inliers / 2);
  std::nth_element(angles.begin(), middle, angles.end(), std::greater<>());
  return *middle;
}

std::optional<BootstrapPair> TestPair(const std::deque<FrameEvent>& held, size_t first,
                                      size_t second, const Session& aliases,
                                      const BootstrapOptions& options, uint64_t seed) {
  const std::vector<FeatureMatch> matches = CommonTracks(held[first], held[second], aliases);
  if (matches.size() < static_cast<size_t>(options.min_inliers)) return std::nullopt;
  const std::vector<Eigen::Vector2d> points_a = PointsOf(held[first]);
  const std::vector<Eigen::Vector2d> points_b = PointsOf(held[second]);
  Rng rng = Rng(seed).Fork(held[first].id.index * 1000003ULL + held[second].id.index);
  const PairVerification pair = VerifyPair(
      points_a, points_b, matches, held[second].camera.MeanFocal(), SearchThoroughly(), rng);
  if (pair.verdict != PairVerdict::kGeneral ||
      pair.inliers.size() < static_cast<size_t>(options.min_inliers)) {
    return std::nullopt;
  }
  const double angle =
      WideAngle(points_a, points_b, matches, pair, static_cast<size_t>(options.min_inliers));
  if (angle < Radians(options.min_angle_deg)) return std::nullopt;
  return BootstrapPair{first, second, pair.cam_b_from_cam_a, angle, pair.inliers.size()};
}

// At most so many of the numbers below count, the first and the last among them.
std::vector<size_t> SpreadEvenly(size_t count, size_t max) {
  std::vector<size_t> numbers;
  const size_t num = std::min(count, max);
  for (size_t i = 0; i < num; ++i) {
    numbers.push_back(num == count ? i : i * (count - 1) / (max - 1));
  }
  return numbers;
}

}  // namespace

std::optional<BootstrapPair> FindBootstrapPair(const std::deque<FrameEvent>& held,
                                               const Session& aliases,
                                               const BootstrapOptions& options, uint64_t seed) {
  std::optional<BootstrapPair> widest;
  const size_t step = 1 + (held.size() - 1) / kMaxFirstFrames;
  for (size_t first = 0; first + 1 < held.size(); first += step) {
    const auto pair = TestPair(held, first, held.size() - 1, aliases, options, seed);
    if (!pair) continue;
    if (Degrees(pair->angle_rad) >= options.wished_angle_deg) return pair;
    if (!widest || pair->angle_rad > widest->angle_rad) widest = pair;
  }
  return widest;
}

std::optional<BootstrapPair> FindBestBootstrapPair(const std::deque<FrameEvent>& held,
                                                   const Session& aliases,
                                                   const BootstrapOptions& options, uint64_t seed) {
  const std::vector<size_t> frames = SpreadEvenly(held.size(), kMaxOfBest);
  std::optional<BootstrapPair> best;
  for (auto first = frames.begin(); first != frames.end(); ++first) {
    for (auto second = frames.end() - 1; second > first; --second) {
      const auto pair = TestPair(held, *first, *second, aliases, options, seed);
      if (!pair) continue;
      if (!best || pair->angle_rad > best->angle_rad) best = pair;
      break;
    }
  }
  return best;
}

}  // namespace rovio_sfm
