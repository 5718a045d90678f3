#include "rovio_sfm/sessions/align_sessions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "rovio_sfm/geometry/ransac.h"
#include "rovio_sfm/sessions/cross_residual.h"
#include "rovio_sfm/sessions/fit_similarity.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr int kRounds = 3;            // refinement, then the inliers anew
constexpr int kIterations = 20;       // of a fit
constexpr int kSampleIterations = 4;  // of the fit to three matches
constexpr double kMinDepth = 1e-9;

FitSimilarityOptions FitOptions(const AlignOptions& options,
                                const std::optional<ScalePrior>& scale_prior) {
  return {kIterations, options.loss_sigmas, options.sigma_log_distance_floor, scale_prior};
}

std::vector<CrossMatch> CommonOf(const std::vector<CrossMatch>& matches) {
  std::vector<CrossMatch> common;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(common), IsCommon);
  return common;
}

AlignReport CountMatches(const std::vector<CrossMatch>& matches) {
  AlignReport report;
  for (const CrossMatch& match : matches) {
    report.num_matches += match.a.landmark || match.b.landmark ? 1 : 0;
    report.num_common += IsCommon(match) ? 1 : 0;
  }
  return report;
}

AlignReport RefuseAlignment(AlignReport report, AlignRefusal refusal) {
  report.alignment.reset();
  report.refusal = refusal;
  return report;
}

// Similarities from common landmarks. Three landmarks with uncertain distances turn a map by many
// degrees, but their directions are sharp: each sample is fitted by reprojection before it counts.
class SimilarityEstimator {
 public:
  using Model = Sim3;
  static constexpr int kSampleSize = 3;

  SimilarityEstimator(const std::vector<CrossMatch>& common, const AlignOptions& options)
      : common_(common), fit_(FitOptions(options, std::nullopt)) {}

  uint32_t NumData() const { return static_cast<uint32_t>(common_.size()); }

  std::vector<Model> Solve(const std::vector<uint32_t>& sample) const {
    std::vector<Eigen::Vector3d> in_a, in_b;
    for (const uint32_t i : sample) {
      in_a.push_back(common_[i].a.landmark->position);
      in_b.push_back(common_[i].b.landmark->position);
    }
    const auto aligned = AlignPoints(in_a, in_b);
    if (!aligned || !(aligned->scale > 0.0)) return {};
    const FitSimilarityOptions squared{kSampleIterations, 0.0, fit_.sigma_log_distance_floor, {}};
    const auto fitted = FitSimilarity(common_, sample, *aligned, squared);
    return {fitted ? *fitted : *aligned};
  }

  double SquaredResidual(const Model& b_from_a, uint32_t datum) const {
    const auto residual = ResidualOf(common_[datum], b_from_a, fit_.sigma_log_distance_floor);
    return residual ? residual->SquaredMax() : std::numeric_limits<double>::infinity();
  }

  std::optional<Model> Refine(const Model& b_from_a, const std::vector<uint32_t>& inliers) const {
    return FitSimilarity(common_, inliers, b_from_a, fit_);
  }

 private:
  const std::vector<CrossMatch>& common_;
  FitSimilarityOptions fit_;
};

std::vector<uint32_t> SelectInliers(const std::vector<CrossMatch>& matches, const Sim3& b_from_a,
                                    const AlignOptions& options) {
  std::vector<uint32_t> inliers;
  const double squared_threshold = options.threshold_sigmas * options.threshold_sigmas;
  for (uint32_t i = 0; i < matches.size(); ++i) {
    const auto residual = ResidualOf(matches[i], b_from_a, options.sigma_log_distance_floor);
    if (residual && residual->SquaredMax() < squared_threshold) inliers.push_back(i);
  }
  return inliers;
}

// Distinct pairs of landmarks: one pair may be matched in several frames.
int CountCommon(const std::vector<CrossMatch>& matches, const std::vector<uint32_t>& chosen) {
  std::set<std::pair<TrackId, TrackId>> pairs;
  for (const uint32_t i : chosen) {
    if (IsCommon(matches[i])) pairs.insert({matches[i].a.track, matches[i].b.track});
  }
  return static_cast<int>(pairs.size());
}

AlignRefusal CheckCounts(const SessionAlignment& alignment, const AlignOptions& options,
                         bool needs_common) {
  if (static_cast<int>(alignment.inliers.size()) < options.min_inliers) {
    return AlignRefusal::kTooFewInliers;
  }
  if (needs_common && alignment.num_common < options.min_common) {
    return AlignRefusal::kTooFewCommon;
  }
  return AlignRefusal::kNone;
}

// Fills in how certain the alignment is.
AlignRefusal CheckUncertainty(const std::vector<CrossMatch>& matches, const AlignOptions& options,
                              const FitSimilarityOptions& fit, SessionAlignment* alignment) {
  const auto uncertainty =
      MeasureUncertainty(matches, alignment->inliers, alignment->b_from_a, fit);
  if (!uncertainty) return AlignRefusal::kUndetermined;
  alignment->rms_sigmas = uncertainty->rms_sigmas;
  alignment->sigma_rotation_rad = uncertainty->sigma_rotation_rad;
  alignment->sigma_log_scale =
      std::hypot(uncertainty->sigma_log_scale, options.sigma_log_scale_floor);
  if (alignment->sigma_rotation_rad > options.max_sigma_rotation_rad) {
    return AlignRefusal::kRotationUncertain;
  }
  if (alignment->sigma_log_scale > options.max_sigma_log_scale) {
    return AlignRefusal::kScaleUncertain;
  }
  return AlignRefusal::kNone;
}

std::vector<double> LogDepthRatios(const std::vector<CrossMatch>& matches, const Rigid3& cam_from_a,
                                   const Rigid3& cam_from_b) {
  std::vector<double> ratios;
  for (const CrossMatch& match : matches) {
    if (!IsCommon(match)) continue;
    const double depth_a = (cam_from_a * match.a.landmark->position).z();
    const double depth_b = (cam_from_b * match.b.landmark->position).z();
    if (depth_a > kMinDepth && depth_b > kMinDepth) ratios.push_back(std::log(depth_b / depth_a));
  }
  return ratios;
}

}  // namespace

const char* ToString(AlignRefusal refusal) {
  switch (refusal) {
    case AlignRefusal::kNone:
      return "aligned";
    case AlignRefusal::kTooFewMatches:
      return "too few matches with landmarks";
    case AlignRefusal::kNoModel:
      return "no similarity fits: landmarks on one line, in one place or false";
    case AlignRefusal::kTooFewInliers:
      return "too few matches agree with one similarity";
    case AlignRefusal::kTooFewCommon:
      return "too few landmarks are common to both sessions";
    case AlignRefusal::kScaleUncertain:
      return "the scale between the sessions is too uncertain";
    case AlignRefusal::kRotationUncertain:
      return "the rotation between the sessions is too uncertain";
    case AlignRefusal::kUndetermined:
      return "the matches do not determine a similarity";
  }
  return "unknown";
}

AlignReport AlignByPoints(const std::vector<CrossMatch>& matches, const AlignOptions& options,
                          Rng& rng) {
  const AlignReport counts = CountMatches(matches);
  if (counts.num_common < options.min_common || counts.num_matches < options.min_inliers) {
    return RefuseAlignment(counts, AlignRefusal::kTooFewMatches);
  }
  const std::vector<CrossMatch> common = CommonOf(matches);
  RansacOptions ransac;
  ransac.max_iterations = options.max_iterations;
  ransac.min_iterations = std::min(ransac.min_iterations, options.max_iterations);
  ransac.confidence = options.confidence;
  ransac.threshold = options.threshold_sigmas;
  const auto found = Ransac(SimilarityEstimator(common, options), ransac, rng);
  if (!found) return RefuseAlignment(counts, AlignRefusal::kNoModel);
  return RefineAlignment(matches, found->model, options);
}

AlignReport AlignFromPose(const std::vector<CrossMatch>& matches, const Rigid3& cam_from_a,
                          const Rigid3& cam_from_b, const AlignOptions& options) {
  const AlignReport counts = CountMatches(matches);
  const std::vector<double> ratios = LogDepthRatios(matches, cam_from_a, cam_from_b);
  if (static_cast<int>(ratios.size()) < options.min_common) {
    return RefuseAlignment(counts, AlignRefusal::kTooFewMatches);
  }
  const Sim3 b_from_a = SimilarityFromCamera(cam_from_a, cam_from_b, std::exp(Median(ratios)));
  AlignReport report = RefineAlignment(matches, b_from_a, options);
  if (report.alignment) report.alignment->by_resection = true;
  return report;
}

AlignReport RefineAlignment(const std::vector<CrossMatch>& matches, const Sim3& initial_b_from_a,
                            const AlignOptions& options,
                            const std::optional<ScalePrior>& scale_prior) {
  AlignReport report = CountMatches(matches);
  const FitSimilarityOptions fit = FitOptions(options, scale_prior);
  SessionAlignment alignment;
  alignment.b_from_a = initial_b_from_a;
  alignment.inliers = SelectInliers(matches, initial_b_from_a, options);
  for (int round = 0; round < kRounds; ++round) {
    if (alignment.inliers.empty()) return RefuseAlignment(report, AlignRefusal::kTooFewInliers);
    const auto fitted = FitSimilarity(matches, alignment.inliers, alignment.b_from_a, fit);
    if (!fitted) return RefuseAlignment(report, AlignRefusal::kNoModel);
    alignment.b_from_a = *fitted;
    alignment.inliers = SelectInliers(matches, *fitted, options);
  }
  alignment.num_common = CountCommon(matches, alignment.inliers);
  const AlignRefusal by_counts = CheckCounts(alignment, options, !scale_prior);
  if (by_counts != AlignRefusal::kNone) return RefuseAlignment(report, by_counts);
  const AlignRefusal by_uncertainty = CheckUncertainty(matches, options, fit, &alignment);
  if (by_uncertainty != AlignRefusal::kNone) return RefuseAlignment(report, by_uncertainty);
  report.alignment = std::move(alignment);
  return report;
}

Sim3 SimilarityFromCamera(const Rigid3& cam_from_a, const Rigid3& cam_from_b, double scale) {
  const Rigid3 b_from_cam = Inverse(cam_from_b);
  return Sim3{scale, b_from_cam.rotation, b_from_cam.translation} *
         Sim3{1.0, cam_from_a.rotation, cam_from_a.translation};
}

}  // namespace rovio_sfm
