#include "rovio_sfm/matching/match_posed.h"

#include <Eigen/Core>

#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/matching/filter_matches.h"
#include "rovio_sfm/matching/match_descriptors.h"

namespace rovio_sfm {
namespace {

constexpr double kMinBaseline = 1e-9;  // map units

uint32_t Count(const std::vector<FeatureMatch>& matches) {
  return static_cast<uint32_t>(matches.size());
}

std::vector<FeatureMatch> FilterByPose(const FrameFeatures& a, const FrameFeatures& b,
                                       const Rigid3& b_from_a,
                                       const std::vector<FeatureMatch>& matches, double band) {
  const Eigen::Matrix3d essential = EssentialFromPose(b_from_a);
  std::vector<FeatureMatch> kept;
  for (const FeatureMatch& match : matches) {
    const Eigen::Vector2d& x_a = a.keypoints[match.a].x_normalized;
    const Eigen::Vector2d& x_b = b.keypoints[match.b].x_normalized;
    if (SquaredSampsonError(essential, x_a, x_b) > band * band) continue;
    if (IsInFront(b_from_a, x_a, x_b)) kept.push_back(match);
  }
  return kept;
}

}  // namespace

PairMatches MatchPosed(uint32_t other_index, const FrameFeatures& a, const FrameFeatures& b,
                       const Rigid3& b_from_a, const std::vector<DepthRange>& ranges_in_b,
                       double focal_px, const PosedMatchOptions& options) {
  PairMatches pair;
  pair.other_index = other_index;
  pair.cam_from_other = b_from_a;
  pair.counts.features = static_cast<uint32_t>(b.keypoints.size());
  if (b_from_a.translation.norm() < kMinBaseline) return pair;
  std::vector<FeatureMatch> matches = MatchDescriptors(a.descriptors, b.descriptors, options.match);
  matches = FilterByRatio(matches, options.max_ratio);
  pair.counts.ratio = pair.counts.percentile = Count(matches);
  matches = FilterOneToOne(matches);
  pair.counts.one_to_one = Count(matches);
  pair.inliers = FilterByPose(a, b, b_from_a, matches, options.band_px / focal_px);
  pair.counts.ransac = Count(pair.inliers);
  const auto found =
      MatchInRange(a, b, b_from_a, ranges_in_b, pair.inliers, focal_px, options.range);
  pair.inliers.insert(pair.inliers.end(), found.begin(), found.end());
  pair.counts.guided = Count(pair.inliers);
  pair.verdict = PairVerdict::kGeneral;
  return pair;
}

}  // namespace rovio_sfm
