#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// When geometry that fits is proof (design 5.4): FAB-MAP proposes, geometry decides, absence
// refutes.
struct EvidenceOptions {
  int min_inliers = 25;
  // Rows and columns that hold inliers: a poster, a sign or one object does not fill so many.
  int grid_size = 4;
  int min_rows = 3;
  int min_columns = 3;
  // One object at a few metres stays below min_depth_ratio. Or so large a share off the best plane.
  double min_depth_ratio = 1.6;
  double min_off_plane_share = 0.15;
  double max_plane_error = 0.05;
  // The same place shows a fifth at least (0.2 to 0.5 of two simulated drives, 0.15 to 0.35 of two
  // hand held ones with blur); another one that looks alike only what it has in common (0.03 to
  // 0.06 of the repeats of an engine room).
  int min_visible = 15;
  double min_matched_share = 0.2;
  double refuted_share = 0.1;
  // From where no view of the other session is near, nobody knows what should be seen: then so many
  // inliers and such a share of all that may be seen are proof, if neighbours agree.
  int min_wide_inliers = 100;
  double min_wide_share = 0.4;
  // Of the alignment: sessions of nearly pure rotation fit at almost any scale.
  double max_sigma_log_scale = 0.03;
  double max_log_scale_gap = 0.05;
  double refuted_log_scale_gap = 0.25;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("min_inliers", min_inliers, 4, 10000,
                    "distinct features of the query frame; four samples' worth beyond chance");
    table.AddNumber("grid_size", grid_size, 1, 100, "rows and columns of the image's cells");
    table.AddNumber("min_rows", min_rows, 1, 100, "that hold inliers");
    table.AddRule("min_rows", min_rows <= grid_size, "at most grid_size");
    table.AddNumber("min_columns", min_columns, 1, 100, "that hold inliers");
    table.AddRule("min_columns", min_columns <= grid_size, "at most grid_size");
    table.AddNumber("min_depth_ratio", min_depth_ratio, 1.0, 100.0, "90th to 10th percentile");
    table.AddNumber("min_off_plane_share", min_off_plane_share, 0.0, 1.0, "off the best plane");
    table.AddNumber("max_plane_error", max_plane_error, 1e-4, 1.0, "as a share of the distance");
    table.AddNumber("min_visible", min_visible, 1, 100000, "that should be seen, to know a share");
    table.AddNumber("min_matched_share", min_matched_share, 0.0, 1.0, "of them");
    table.AddNumber("refuted_share", refuted_share, 0.0, 1.0, "of them; below: refuted");
    table.AddRule("refuted_share", refuted_share <= min_matched_share, "at most min_matched_share");
    table.AddNumber("min_wide_inliers", min_wide_inliers, 4, 100000,
                    "where fewer than min_visible should be seen: proof from so many");
    table.AddNumber("min_wide_share", min_wide_share, 0.0, 1.0,
                    "and such a share of what views farther aside show");
    table.AddNumber("max_sigma_log_scale", max_sigma_log_scale, 0.001, 1.0,
                    "of the scale, where odometry does not tell both");
    table.AddNumber("max_log_scale_gap", max_log_scale_gap, 0.001, 1.0, "of neighbouring frames");
    table.AddNumber("refuted_log_scale_gap", refuted_log_scale_gap, 0.001, 10.0, "above: refuted");
    table.AddRule("refuted_log_scale_gap", refuted_log_scale_gap >= max_log_scale_gap,
                  "at least max_log_scale_gap");
  }
};

// An inlier of an overlap as the query frame sees it.
struct EvidenceInlier {
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();
  double depth = 0.0;  // of its landmark in the query camera, any unit, above 0
};

struct OverlapEvidence {
  Camera camera;                        // of the query frame
  std::vector<EvidenceInlier> inliers;  // one per feature
  int num_visible = 0;  // landmarks of the other map in the frame's view, from like angle and range
  int num_visible_matched = 0;
  int num_wide = 0;  // the same, from angles from which it may be visible
  int num_wide_matched = 0;
  double sigma_log_scale = 0.0;              // of the alignment; 0 where odometry tells both scales
  std::vector<double> neighbour_log_scales;  // log(scale by a neighbour / scale of the overlap)
};

enum class EvidenceReason : uint8_t {
  kComplete = 0,
  kTooFewInliers = 1,  // from here on: why provisional
  kNotSpread = 2,
  kOneDepth = 3,
  kVisibilityUnknown = 4,
  kLowShare = 5,
  kScaleUnknown = 6,
  kNeighboursDisagree = 7,
  kAbsent = 8,  // from here on: why refused
  kNeighboursContradict = 9,
};

struct EvidenceVerdict {
  MergeVerdict verdict = MergeVerdict::kProvisional;  // accepted, provisional or refused
  EvidenceReason reason = EvidenceReason::kTooFewInliers;
  std::string text;  // one sentence with the figures that decided
  int num_inliers = 0, num_rows = 0, num_columns = 0;
  double depth_ratio = 0.0, off_plane_share = 0.0;
  double matched_share = 0.0;  // 0 where it is not known
  double wide_share = 0.0;
  double log_scale_gap = 0.0;  // median of the neighbours', absolute
};

EvidenceVerdict JudgeOverlap(const OverlapEvidence& evidence, const EvidenceOptions& options);

}  // namespace rovio_sfm
