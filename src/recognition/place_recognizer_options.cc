#include "rovio_sfm/recognition/place_recognizer_options.h"

namespace rovio_sfm {

CandidateOptions PlaceRecognizerOptions::OverlapCandidates() {
  CandidateOptions options;
  options.min_score = -30.0;
  options.max_candidates = 6;
  return options;
}

}  // namespace rovio_sfm
