#include "rovio_sfm/recognition/place_recognizer_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool CandidateOptions::IsValid(std::string* error) const {
  OptionChecker checker("candidates", error);
  checker.Range("min_score", min_score, -1e6, 1e6);
  checker.Range("max_candidates", max_candidates, 1, 100);
  checker.Range("same_place_keyframes", same_place_keyframes, 0, 1000);
  return checker.Passed();
}

CandidateOptions PlaceRecognizerOptions::OverlapCandidates() {
  CandidateOptions options;
  options.min_score = -60.0;
  options.max_candidates = 6;
  return options;
}

bool PlaceRecognizerOptions::IsValid(std::string* error) const {
  OptionChecker checker("place_recognizer", error);
  checker.Nested(fabmap);
  checker.Nested(motion_prior);
  checker.Nested(candidates);
  checker.Nested(overlap_candidates);
  checker.Nested(recent_past);
  checker.Nested(verify);
  return checker.Passed();
}

}  // namespace rovio_sfm
