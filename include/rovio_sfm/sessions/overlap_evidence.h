#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/merge_report.h"

namespace rovio_sfm {

// When geometry that fits is proof (design 5.4): FAB-MAP proposes, geometry decides, absence
// refutes.
struct EvidenceOptions {
  int min_inliers = 25;  // distinct features of the query frame; four samples' worth beyond chance
  int grid_size = 4;     // the image is cut into so many rows and columns of cells
  // Rows and columns that hold inliers: a poster, a sign or one object does not fill so many.
  int min_rows = 3;
  int min_columns = 3;
  // 90th to 10th percentile of the depths; one object at a few metres stays below. Or so large a
  // share of inliers off the best plane, by more than a twentieth of their distance.
  double min_depth_ratio = 1.6;
  double min_off_plane_share = 0.15;
  double max_plane_error = 0.05;
  // Of the other map's landmarks that should be seen, so many must be for a share to be known. The
  // same place shows a fifth at least (0.2 to 0.5 of two simulated drives, 0.15 to 0.35 of two hand
  // held ones with blur); another one that looks alike only what it has in common (0.03 to 0.06 of
  // the repeats of an engine room).
  int min_visible = 15;
  double min_matched_share = 0.2;
  double refuted_share = 0.1;
  // Neighbours of the query frame must give the same scale.
  double max_log_scale_gap = 0.05;
  double refuted_log_scale_gap = 0.25;

  // Names the field, its value and its bound.
  bool IsValid(std::string* error) const;
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
  std::vector<double> neighbour_log_scales;  // log(scale by a neighbour / scale of the overlap)
};

enum class EvidenceReason : uint8_t {
  kComplete = 0,
  kTooFewInliers = 1,  // from here on: why provisional
  kNotSpread = 2,
  kOneDepth = 3,
  kVisibilityUnknown = 4,
  kLowShare = 5,
  kNeighboursDisagree = 6,
  kAbsent = 7,  // from here on: why refused
  kNeighboursContradict = 8,
};

struct EvidenceVerdict {
  MergeVerdict verdict = MergeVerdict::kProvisional;  // accepted, provisional or refused
  EvidenceReason reason = EvidenceReason::kTooFewInliers;
  std::string text;  // one sentence with the figures that decided
  int num_inliers = 0, num_rows = 0, num_columns = 0;
  double depth_ratio = 0.0, off_plane_share = 0.0;
  double matched_share = 0.0;  // 0 where it is not known
  double log_scale_gap = 0.0;  // median of the neighbours', absolute
};

EvidenceVerdict JudgeOverlap(const OverlapEvidence& evidence, const EvidenceOptions& options);

}  // namespace rovio_sfm
