#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/places/fabmap.h"
#include "rovio_sfm/places/motion_prior.h"
#include "rovio_sfm/recognition/recent_past.h"
#include "rovio_sfm/recognition/verify_place.h"

namespace rovio_sfm {

// How candidates are chosen by appearance. They are ranked by likelihood and motion prior, never by
// the posterior, which saturates; geometry decides.
struct CandidateOptions {
  double min_score = -20.0;      // FabmapResult::score below which nothing is verified; -1e6 to 1e6
  int max_candidates = 3;        // verified, best first; 1 to 100
  int same_place_keyframes = 5;  // nearer ones of one drive are one candidate; 0 to 1000

  bool IsValid(std::string* error) const;
};

// What place recognition can be told; config/place_recognition.yaml mirrors it.
struct PlaceRecognizerOptions {
  FabmapOptions fabmap;
  MotionPriorOptions motion_prior;
  CandidateOptions candidates;
  CandidateOptions overlap_candidates = OverlapCandidates();  // of FindOverlaps: looks closer
  RecentPastOptions recent_past;
  VerifyPlaceOptions verify;
  uint64_t seed = 1;

  static CandidateOptions OverlapCandidates();
  bool IsValid(std::string* error) const;
};

}  // namespace rovio_sfm
