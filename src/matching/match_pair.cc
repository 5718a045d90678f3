#include "rovio_sfm/matching/match_pair.h"

#include <vector>

#include "rovio_sfm/matching/filter_matches.h"

namespace rovio_sfm {
namespace {

uint32_t Count(const std::vector<FeatureMatch>& matches) {
  return static_cast<uint32_t>(matches.size());
}

// The filters that look at descriptors alone.
std::vector<FeatureMatch> MatchByAppearance(const FrameFeatures& other,
                                            const FrameFeatures& features,
                                            const PairOptions& options, MatchCounts* counts) {
  counts->features = static_cast<uint32_t>(features.keypoints.size());
  std::vector<FeatureMatch> matches =
      MatchDescriptors(other.descriptors, features.descriptors, options.match);
  matches = FilterByRatio(matches, options.max_ratio);
  counts->ratio = Count(matches);
  matches = FilterByMeanDistance(matches, options.max_mean_factor);
  counts->percentile = Count(matches);
  matches = FilterOneToOne(matches);
  counts->one_to_one = Count(matches);
  return matches;
}

std::vector<Eigen::Vector2d> NormalizedPoints(const FrameFeatures& features) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(features.keypoints.size());
  for (const Keypoint& keypoint : features.keypoints) points.push_back(keypoint.x_normalized);
  return points;
}

void AddGuided(const FrameFeatures& other, const FrameFeatures& features, double focal_px,
               const PairOptions& options, PairMatches* pair) {
  if (!options.use_guided || pair->verdict != PairVerdict::kGeneral) return;
  const std::vector<FeatureMatch> guided =
      MatchGuided(other, features, pair->cam_from_other, pair->inliers, focal_px, options.guided);
  pair->inliers.insert(pair->inliers.end(), guided.begin(), guided.end());
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
  PairMatches pair;
  pair.other_index = other_index;
  const std::vector<FeatureMatch> matches =
      MatchByAppearance(other, features, options, &pair.counts);
  const PairVerification verified = VerifyPair(NormalizedPoints(other), NormalizedPoints(features),
                                               matches, focal_px, options.verify, rng);
  pair.verdict = verified.verdict;
  pair.cam_from_other = verified.cam_b_from_cam_a;
  pair.median_parallax_rad = verified.median_parallax_rad;
  for (const uint32_t i : verified.inliers) pair.inliers.push_back(matches[i]);
  pair.counts.ransac = Count(pair.inliers);
  AddGuided(other, features, focal_px, options, &pair);
  pair.counts.guided = Count(pair.inliers);
  return pair;
}

}  // namespace rovio_sfm
