#pragma once

#include <string>

#include "rovio_sfm/merging/search_across.h"
#include "rovio_sfm/sessions/align_sessions.h"
#include "rovio_sfm/sessions/overlap_evidence.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// When and how sessions are joined (§4.3, design 5.4).
struct MergeOptions {
  bool automatic = true;
  int min_keyframes = 8;
  int seed_after = 8;
  int search_neighbours = 2;
  int patience = 400;
  int max_overlaps = 0;
  double max_shared_landmarks = 0.3;
  double max_scale_gap = 0.05;
  double max_rotation_gap_deg = 3.0;
  double max_drift = 0.03;
  double max_gap_px = 3.0;
  bool use_pose_graph = true;
  AlignOptions align;
  SearchAcrossOptions search;
  EvidenceOptions evidence;

  void DescribeOptions(OptionTable& table) {
    table.AddFlag("automatic", automatic, "place matches merge by themselves; else by service");
    table.AddNumber("min_keyframes", min_keyframes, 3, 1000, "running, with fewer: not merged yet");
    table.AddNumber("seed_after", seed_after, 2, 1000, "held keyframes; then a map seen starts it");
    table.AddNumber("search_neighbours", search_neighbours, 0, 20,
                    "keyframes on both sides of an overlap that are searched");
    table.AddNumber("patience", patience, 1, 1'000'000, "keyframes for which a place match waits");
    table.AddNumber("max_overlaps", max_overlaps, 0, 1'000'000, "used of two drives; 0: all");
    table.AddNumber("max_shared_landmarks", max_shared_landmarks, 0.0, 1.0,
                    "of two provisional overlaps that confirm each other, at most this share");
    table.AddNumber("max_scale_gap", max_scale_gap, 1e-4, 1.0, "of them, and of a loop: relative");
    table.AddNumber("max_rotation_gap_deg", max_rotation_gap_deg, 0.01, 45.0, "of them");
    table.AddNumber("max_drift", max_drift, 0.0, 1.0, "of a loop's way: more needs full evidence");
    table.AddNumber("max_gap_px", max_gap_px, 0.0, 100.0,
                    "median error of links from which a map is adjusted at once");
    table.AddFlag("use_pose_graph", use_pose_graph, "spreads a gap before the adjustment");
    table.AddGroup("align", align, "where one session lies in the other");
    table.AddGroup("search", search, "landmarks of one session in the frames of the other");
    table.AddGroup("evidence", evidence, "when geometry that fits is proof");
  }
};

}  // namespace rovio_sfm
