#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/places/fabmap.h"
#include "rovio_sfm/places/motion_prior.h"
#include "rovio_sfm/recognition/recent_past.h"
#include "rovio_sfm/recognition/verify_place.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// How candidates are chosen by appearance. They are ranked by likelihood and motion prior, never by
// the posterior, which saturates; geometry decides.
struct CandidateOptions {
  double min_score = -10.0;
  int max_candidates = 3;
  int same_place_keyframes = 5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("min_score", min_score, -1e6, 1e6, "log likelihood against a new place's");
    table.AddNumber("max_candidates", max_candidates, 1, 100, "verified, best first");
    table.AddNumber("same_place_keyframes", same_place_keyframes, 0, 1000,
                    "nearer ones of one drive are one candidate");
  }
};

// What place recognition can be told; config/place_recognition.yaml mirrors it.
struct PlaceRecognizerOptions {
  int max_features = 2000;
  FabmapOptions fabmap;
  MotionPriorOptions motion_prior;
  CandidateOptions candidates;
  CandidateOptions overlap_candidates = OverlapCandidates();
  RecentPastOptions recent_past;
  VerifyPlaceOptions verify;
  uint64_t seed = 1;

  static CandidateOptions OverlapCandidates();

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_features", max_features, 100, 100000,
                    "words of an image: of its largest features");
    table.AddGroup("fabmap", fabmap, "");
    table.AddGroup("motion_prior", motion_prior, "where the robot may be, given where it was");
    table.AddGroup("candidates", candidates, "what appearance proposes to geometry");
    table.AddGroup("overlap_candidates", overlap_candidates,
                   "for find_overlaps, which looks closer");
    table.AddGroup("recent_past", recent_past, "what a keyframe of its drive is not matched with");
    table.AddGroup("verify", verify, "geometry");
    table.AddNumber("seed", seed, 0, kNoLimit, "");
  }
};

}  // namespace rovio_sfm
