#include "rovio_sfm/sessions/overlap_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace rovio_sfm {
namespace {

constexpr int kPlaneRounds = 10;         // of reweighting
constexpr double kMinPlaneError = 1e-6;  // keeps weights finite on an exact plane

double Percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

int CellOf(double x_px, int size_px, int num_cells) {
  const int cell = static_cast<int>(std::floor(x_px * num_cells / size_px));
  return std::clamp(cell, 0, num_cells - 1);
}

void MeasureSpread(const OverlapEvidence& evidence, int grid_size, EvidenceVerdict* verdict) {
  std::set<int> rows, columns;
  for (const EvidenceInlier& inlier : evidence.inliers) {
    const Eigen::Vector2d x_px = PixelFromNormalized(evidence.camera, inlier.x_normalized);
    columns.insert(CellOf(x_px.x(), evidence.camera.width, grid_size));
    rows.insert(CellOf(x_px.y(), evidence.camera.height, grid_size));
  }
  verdict->num_rows = static_cast<int>(rows.size());
  verdict->num_columns = static_cast<int>(columns.size());
}

double DepthRatio(const std::vector<EvidenceInlier>& inliers) {
  std::vector<double> depths;
  for (const EvidenceInlier& inlier : inliers) depths.push_back(inlier.depth);
  const double near = Percentile(depths, 0.1);
  return near > 0.0 ? Percentile(depths, 0.9) / near : 0.0;
}

// How far each point lies off a plane, by its distance. On a plane the inverse depth is linear in
// the normalised coordinates.
std::vector<double> PlaneErrors(const std::vector<EvidenceInlier>& inliers,
                                const Eigen::Vector3d& plane) {
  std::vector<double> errors;
  for (const EvidenceInlier& inlier : inliers) {
    errors.push_back(std::abs(plane.dot(inlier.x_normalized.homogeneous()) * inlier.depth - 1.0));
  }
  return errors;
}

// The plane of the least absolute errors, by reweighting.
double OffPlaneShare(const std::vector<EvidenceInlier>& inliers, double max_error) {
  std::vector<double> errors(inliers.size(), 1.0);
  for (int round = 0; round < kPlaneRounds; ++round) {
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < inliers.size(); ++i) {
      const Eigen::Vector3d ray = inliers[i].x_normalized.homogeneous();
      const Eigen::Vector3d row = inliers[i].depth * ray;
      const double weight = 1.0 / std::max(errors[i], kMinPlaneError);
      hessian += weight * row * row.transpose();
      gradient += weight * row;
    }
    const Eigen::Vector3d plane = hessian.ldlt().solve(gradient);
    if (!plane.allFinite()) return 0.0;
    errors = PlaneErrors(inliers, plane);
  }
  const auto num_off = std::count_if(errors.begin(), errors.end(),
                                     [max_error](double error) { return error > max_error; });
  return inliers.empty() ? 0.0 : static_cast<double>(num_off) / static_cast<double>(inliers.size());
}

double Share(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

EvidenceVerdict Measure(const OverlapEvidence& evidence, const EvidenceOptions& options) {
  EvidenceVerdict verdict;
  verdict.num_inliers = static_cast<int>(evidence.inliers.size());
  MeasureSpread(evidence, options.grid_size, &verdict);
  verdict.depth_ratio = DepthRatio(evidence.inliers);
  verdict.off_plane_share = OffPlaneShare(evidence.inliers, options.max_plane_error);
  verdict.matched_share = Share(evidence.num_visible_matched, evidence.num_visible);
  verdict.wide_share = Share(evidence.num_wide_matched, evidence.num_wide);
  std::vector<double> gaps;
  for (const double gap : evidence.neighbour_log_scales) gaps.push_back(std::abs(gap));
  verdict.log_scale_gap = Percentile(gaps, 0.5);
  return verdict;
}

// Overwhelming from aside, where no view says what should be seen.
bool IsPlainFromAside(const EvidenceVerdict& figures, const OverlapEvidence& evidence,
                      const EvidenceOptions& options) {
  return figures.num_inliers >= options.min_wide_inliers &&
         figures.wide_share >= options.min_wide_share && !evidence.neighbour_log_scales.empty();
}

// Without odometry one view may fit a session of nearly pure rotation at a scale that no other has.
bool IsScaleKnown(const OverlapEvidence& evidence, const EvidenceOptions& options) {
  return evidence.sigma_log_scale == 0.0 ||
         (evidence.sigma_log_scale <= options.max_sigma_log_scale &&
          !evidence.neighbour_log_scales.empty());
}

// What speaks against the overlap first: what refutes it, then what is missing.
EvidenceReason Weigh(const EvidenceVerdict& figures, const OverlapEvidence& evidence,
                     const EvidenceOptions& options) {
  const bool share_is_known = evidence.num_visible >= options.min_visible;
  if (share_is_known && figures.matched_share < options.refuted_share) {
    return EvidenceReason::kAbsent;
  }
  if (figures.log_scale_gap > options.refuted_log_scale_gap) {
    return EvidenceReason::kNeighboursContradict;
  }
  if (figures.num_inliers < options.min_inliers) return EvidenceReason::kTooFewInliers;
  if (figures.num_rows < options.min_rows || figures.num_columns < options.min_columns) {
    return EvidenceReason::kNotSpread;
  }
  if (figures.depth_ratio < options.min_depth_ratio &&
      figures.off_plane_share < options.min_off_plane_share) {
    return EvidenceReason::kOneDepth;
  }
  if (!share_is_known && !IsPlainFromAside(figures, evidence, options)) {
    return EvidenceReason::kVisibilityUnknown;
  }
  if (share_is_known && figures.matched_share < options.min_matched_share) {
    return EvidenceReason::kLowShare;
  }
  if (!IsScaleKnown(evidence, options)) return EvidenceReason::kScaleUnknown;
  if (figures.log_scale_gap > options.max_log_scale_gap) {
    return EvidenceReason::kNeighboursDisagree;
  }
  return EvidenceReason::kComplete;
}

MergeVerdict VerdictOf(EvidenceReason reason) {
  if (reason == EvidenceReason::kComplete) return MergeVerdict::kAccepted;
  return reason < EvidenceReason::kAbsent ? MergeVerdict::kProvisional : MergeVerdict::kRefused;
}

std::string DescribeWide(const OverlapEvidence& evidence) {
  return std::to_string(evidence.num_wide_matched) + " of " + std::to_string(evidence.num_wide) +
         " landmarks that may be visible from aside are matched";
}

std::string DescribeShare(const OverlapEvidence& evidence) {
  return std::to_string(evidence.num_visible_matched) + " of " +
         std::to_string(evidence.num_visible) + " landmarks that should be visible are matched";
}

std::string Rounded(double value) {
  std::ostringstream out;
  out.precision(3);
  out << value;
  return out.str();
}

std::string Describe(const EvidenceVerdict& verdict, const OverlapEvidence& evidence,
                     const EvidenceOptions& options) {
  const bool share_is_known = evidence.num_visible >= options.min_visible;
  const std::string num_inliers = std::to_string(verdict.num_inliers);
  switch (verdict.reason) {
    case EvidenceReason::kComplete:
      return num_inliers + " inliers spread over the image and over depths, " +
             (share_is_known ? DescribeShare(evidence) : DescribeWide(evidence));
    case EvidenceReason::kTooFewInliers:
      return "only " + num_inliers + " inliers";
    case EvidenceReason::kNotSpread:
      return "inliers in only " + std::to_string(verdict.num_rows) + " rows and " +
             std::to_string(verdict.num_columns) + " columns of the image";
    case EvidenceReason::kOneDepth:
      return "inliers on one plane at one depth: ratio of depths " + Rounded(verdict.depth_ratio) +
             ", share off the plane " + Rounded(verdict.off_plane_share);
    case EvidenceReason::kVisibilityUnknown:
      return "only " + std::to_string(evidence.num_visible) +
             " landmarks of the other map should be visible; " + DescribeWide(evidence);
    case EvidenceReason::kLowShare:
    case EvidenceReason::kAbsent:
      return "only " + DescribeShare(evidence);
    case EvidenceReason::kScaleUnknown:
      if (evidence.sigma_log_scale <= options.max_sigma_log_scale) {
        return "no neighbouring frame tells the scale";
      }
      return "the scale is known to " + Rounded(100.0 * evidence.sigma_log_scale) + " % only";
    case EvidenceReason::kNeighboursDisagree:
    case EvidenceReason::kNeighboursContradict:
      return "neighbouring frames give a scale that differs by a factor of " +
             Rounded(std::exp(verdict.log_scale_gap));
  }
  return "";
}

}  // namespace

EvidenceVerdict JudgeOverlap(const OverlapEvidence& evidence, const EvidenceOptions& options) {
  EvidenceVerdict verdict = Measure(evidence, options);
  verdict.reason = Weigh(verdict, evidence, options);
  verdict.verdict = VerdictOf(verdict.reason);
  verdict.text = Describe(verdict, evidence, options);
  return verdict;
}

}  // namespace rovio_sfm
