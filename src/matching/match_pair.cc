#include "rovio_sfm/matching/match_pair.h"

#include <utility>
#include <vector>

#include "rovio_sfm/matching/descriptor_distance.h"
#include "rovio_sfm/matching/filter_matches.h"

namespace rovio_sfm {
namespace {

// Expected matches look more alike than found ones: so much smaller is the mean of their distances.
constexpr float kExpectedFactor = 1.12f;

uint32_t Count(const std::vector<FeatureMatch>& matches) {
  return static_cast<uint32_t>(matches.size());
}

std::vector<FeatureMatch> FilterByDistance(std::vector<FeatureMatch> matches,
                                           const PairOptions& options, MatchCounts* counts) {
  counts->ratio = Count(matches);
  matches = FilterByMeanDistance(matches, options.max_mean_factor);
  counts->percentile = Count(matches);
  matches = FilterOneToOne(matches);
  counts->one_to_one = Count(matches);
  return matches;
}

// The filters that look at descriptors alone.
std::vector<FeatureMatch> MatchByAppearance(const FrameFeatures& other,
                                            const FrameFeatures& features,
                                            const PairOptions& options, MatchCounts* counts) {
  const std::vector<FeatureMatch> matches =
      MatchDescriptors(other.descriptors, features.descriptors, options.match);
  return FilterByDistance(FilterByRatio(matches, options.max_ratio), options, counts);
}

std::vector<Eigen::Vector2d> NormalizedPoints(const FrameFeatures& features) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(features.keypoints.size());
  for (const Keypoint& keypoint : features.keypoints) points.push_back(keypoint.x_normalized);
  return points;
}

void AddGuided(const FrameFeatures& other, const FrameFeatures& features, double focal_px,
               const GuidedOptions& options, PairMatches* pair) {
  if (pair->verdict != PairVerdict::kGeneral) return;
  const std::vector<FeatureMatch> guided =
      MatchGuided(other, features, pair->cam_from_other, pair->inliers, focal_px, options);
  pair->inliers.insert(pair->inliers.end(), guided.begin(), guided.end());
}

// The filters that look at geometry.
void Verify(const FrameFeatures& other, const FrameFeatures& features,
            const std::vector<FeatureMatch>& matches, double focal_px, const PairOptions& options,
            Rng& rng, PairMatches* pair) {
  const PairVerification verified = VerifyPair(NormalizedPoints(other), NormalizedPoints(features),
                                               matches, focal_px, options.verify, rng);
  pair->verdict = verified.verdict;
  pair->cam_from_other = verified.cam_b_from_cam_a;
  pair->median_parallax_rad = verified.median_parallax_rad;
  for (const uint32_t i : verified.inliers) pair->inliers.push_back(matches[i]);
  pair->counts.ransac = Count(pair->inliers);
  if (options.use_guided) AddGuided(other, features, focal_px, options.guided, pair);
  pair->counts.guided = Count(pair->inliers);
}

PairMatches StartPair(uint32_t other_index, const FrameFeatures& features) {
  PairMatches pair;
  pair.other_index = other_index;
  pair.counts.features = static_cast<uint32_t>(features.keypoints.size());
  return pair;
}

}  // namespace

PairMatches MatchPair(uint32_t other_index, const FrameFeatures& other,
                      const FrameFeatures& features, const Camera& camera,
                      const PairOptions& options, Rng& rng) {
  return MatchPair(other_index, other, features, camera.MeanFocal(), options, rng);
}

PairMatches MatchPair(uint32_t other_index, const FrameFeatures& other,
                      const FrameFeatures& features, double focal_px, const PairOptions& options,
                      Rng& rng) {
  PairMatches pair = StartPair(other_index, features);
  const std::vector<FeatureMatch> matches =
      MatchByAppearance(other, features, options, &pair.counts);
  Verify(other, features, matches, focal_px, options, rng, &pair);
  return pair;
}

PairMatches MatchExpected(uint32_t other_index, const FrameFeatures& other,
                          const FrameFeatures& features, std::vector<FeatureMatch> expected,
                          const Camera& camera, const PairOptions& options, Rng& rng) {
  PairMatches pair = StartPair(other_index, features);
  if (!AreComparable(other.descriptors, features.descriptors)) return pair;
  for (FeatureMatch& match : expected) {
    match.distance = DescriptorDistance(other.descriptors, match.a, features.descriptors, match.b);
  }
  const std::vector<FeatureMatch> matches =
      FilterByDistance(std::move(expected), options, &pair.counts);
  PairOptions milder = options;
  milder.guided.range.max_factor *= kExpectedFactor;
  Verify(other, features, matches, camera.MeanFocal(), milder, rng, &pair);
  return pair;
}

}  // namespace rovio_sfm
