#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/tracks/filter_f2.h"

namespace rovio_sfm {

// When two held frames may start a session (§3.7, design 5.2.1).
struct BootstrapOptions {
  int max_held_frames = 120;       // keyframes, 4 to 1000; the oldest goes when one more comes
  int min_inliers = 100;           // 20 to 10000
  double min_angle_deg = 4.0;      // median parallax of the inliers, 0.5 to 45
  double wished_angle_deg = 16.0;  // taken at once from here, min_angle_deg to 60
  int patience = 5;                // keyframes to wait for a wider pair after the first good one
  int hurry_after = 10;            // held keyframes from which hurried_angle_deg will do, 2 to 1000
  double hurried_angle_deg = 2.0;  // driving forward shows no more, 0.5 to min_angle_deg
  bool IsValid(std::string* error) const;
};

struct ResectOptions {
  double threshold_px = 3.0;  // inlier in RANSAC, 0.5 to 50
  int min_inliers = 20;       // fewer: the frame is weak, 6 to 1000
  int max_iterations = 300;   // 10 to 100000
  bool IsValid(std::string* error) const;
};

struct TriangulateOptions {
  double min_parallax_deg = 1.5;  // 0.1 to 30
  double max_error_px = 4.0;      // reprojection error of an observation, 0.5 to 50
  bool IsValid(std::string* error) const;
};

struct AdjustOptions {
  int local_frames = 10;  // free frames of a local adjustment, 2 to 50
  // Of the local, session and map adjustments of a running drive, 1 to 200; the next goes on.
  int running_max_iterations = 10;
  int final_max_iterations = 50;  // of those at the end of a session or a run, 1 to 1000
  double global_growth =
      0.1;  // a global one when frames or landmarks grew by this share, 0.01 to 10
  int max_global_frames = 500;  // larger maps are adjusted by windows of so many, 10 to 100000
  double loss_px = 1.0;         // scale of the robust loss, 0.1 to 20
  bool IsValid(std::string* error) const;
};

struct PruneOptions {
  double max_error_px = 4.0;        // tau_r, 0.5 to 50
  double final_error_sigmas = 6.0;  // in the final adjustment: of the robust spread, 1 to 20
  bool IsValid(std::string* error) const;
};

struct ScaleOptions {
  double min_distance_m = 0.3;        // length of a window, 0.05 to 10
  double max_rotation_gap_deg = 2.0;  // odometry and vision must agree that well, 0.1 to 45
  double odometry_gain_sigma = 0.05;  // relative; averaging never goes below it, 0.001 to 1
  double sideways_sigma = 0.2;        // relative uncertainty of sideways motion, 0 to 1
  // Of the camera over a flat floor, with the head as in the session's first keyframe; 0: not
  // known; 0 to 10. A second source of scale, and the only one without odometry.
  double camera_height_m = 0.0;
  double camera_height_sigma = 0.03;  // relative, 0.001 to 1
  bool IsValid(std::string* error) const;
};

// How a drive is mapped.
struct MapperOptions {
  BootstrapOptions bootstrap;
  ResectOptions resect;
  TriangulateOptions triangulate;
  AdjustOptions adjust;
  PruneOptions prune;
  ScaleOptions scale;
  FilterF2Options f2;           // when two landmarks of linked tracks become one
  int max_weak_frames = 3;      // more in a row end the session as lost, 0 to 100
  int max_weak_tries = 10;      // later keyframes at which a weak one is tried again, 1 to 1000
  double pixel_sigma_px = 1.0;  // position of a small feature, 0.1 to 20
  double sigma_size_px = 6.0;   // features larger than that are less certain, 1 to 100
  double sigma_exponent = 0.5;  // sigma grows with (size / sigma_size_px) to this power, 0 to 2
  uint64_t seed = 1;
  bool IsValid(std::string* error) const;
};

}  // namespace rovio_sfm
