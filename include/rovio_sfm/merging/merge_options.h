#pragma once

#include <string>

#include "rovio_sfm/merging/search_across.h"
#include "rovio_sfm/sessions/align_sessions.h"
#include "rovio_sfm/sessions/overlap_evidence.h"

namespace rovio_sfm {

// When and how sessions are joined (§4.3, design 5.4).
struct MergeOptions {
  bool automatic = true;      // place matches merge by themselves; false: by service only
  int min_keyframes = 8;      // a running session with fewer is not merged yet; 3 to 1000
  int seed_after = 8;         // held keyframes from which a session is started from a map it sees
  int search_neighbours = 2;  // keyframes on both sides of an overlap that are searched; 0 to 20
  int patience = 400;         // keyframes after which a match stops waiting; 1 to 1 000 000
  int max_overlaps = 0;       // place matches used of two drives; 0: all; 0 to 1 000 000
  // Two provisional overlaps confirm each other where they share at most this part of the
  // landmarks, and agree in scale and rotation (0 to 1; above 0; degrees, above 0).
  double max_shared_landmarks = 0.3;
  double max_scale_gap = 0.05;
  double max_rotation_gap_deg = 3.0;
  // A loop may gape by this part of the way between its ends without asking for full evidence.
  double max_drift = 0.03;  // 0 to 1
  double max_gap_px = 3.0;  // median error of links from which a map is adjusted at once; 0 to 100
  bool use_pose_graph = true;  // spreads a gap before the adjustment
  AlignOptions align;
  SearchAcrossOptions search;
  EvidenceOptions evidence;

  // Names the field, its value and its bound.
  bool IsValid(std::string* error) const;
};

}  // namespace rovio_sfm
