#include "rovio_sfm/merging/merge_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool MergeOptions::IsValid(std::string* error) const {
  OptionChecker checker("merge", error);
  checker.Range("min_keyframes", min_keyframes, 3, 1000);
  checker.Range("seed_after", seed_after, 2, 1000);
  checker.Range("search_neighbours", search_neighbours, 0, 20);
  checker.Range("patience", patience, 1, 1'000'000);
  checker.Range("max_overlaps", max_overlaps, 0, 1'000'000);
  checker.Range("max_shared_landmarks", max_shared_landmarks, 0.0, 1.0);
  checker.Range("max_scale_gap", max_scale_gap, 1e-4, 1.0);
  checker.Range("max_rotation_gap_deg", max_rotation_gap_deg, 0.01, 45.0);
  checker.Range("max_drift", max_drift, 0.0, 1.0);
  checker.Range("max_gap_px", max_gap_px, 0.0, 100.0);
  checker.Nested(align);
  checker.Nested(search);
  checker.Nested(evidence);

  return checker.Passed();
}

}  // namespace rovio_sfm
