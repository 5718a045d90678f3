#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/tracks/filter_f2.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// When two held frames may start a session (§3.7, design 5.2.1).
struct BootstrapOptions {
  int max_held_frames = 120;
  int min_inliers = 100;
  double min_angle_deg = 4.0;
  double wished_angle_deg = 16.0;
  int patience = 5;
  int hurry_after = 10;
  double hurried_angle_deg = 2.0;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_held_frames", max_held_frames, 4, 1000, "keyframes; then the oldest goes");
    table.AddNumber("min_inliers", min_inliers, 20, 10000, "of a pair");
    table.AddNumber("min_angle_deg", min_angle_deg, 0.5, 45.0, "median parallax of the inliers");
    table.AddNumber("wished_angle_deg", wished_angle_deg, 0.5, 60.0, "taken at once from here");
    table.AddRule("wished_angle_deg", wished_angle_deg >= min_angle_deg, "at least min_angle_deg");
    table.AddNumber("patience", patience, 1, 1000, "keyframes after a good pair for a wider one");
    table.AddNumber("hurry_after", hurry_after, 2, 1000, "held frames, then hurried_angle_deg");
    table.AddNumber("hurried_angle_deg", hurried_angle_deg, 0.5, 45.0, "seen driving forward");
    table.AddRule("hurried_angle_deg", hurried_angle_deg <= min_angle_deg, "at most min_angle_deg");
  }
};

struct ResectOptions {
  double threshold_px = 3.0;
  int min_inliers = 20;
  int max_iterations = 300;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("threshold_px", threshold_px, 0.5, 50.0, "largest error of an inlier");
    table.AddNumber("min_inliers", min_inliers, 6, 1000, "fewer: the frame is weak");
    table.AddNumber("max_iterations", max_iterations, 10, 100000, "samples");
  }
};

struct TriangulateOptions {
  double min_parallax_deg = 1.5;
  double max_error_px = 4.0;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("min_parallax_deg", min_parallax_deg, 0.1, 30.0, "of the widest two views");
    table.AddNumber("max_error_px", max_error_px, 0.5, 50.0, "reprojection of an observation");
  }
};

struct AdjustOptions {
  int local_frames = 10;
  int running_max_iterations = 10;
  int final_max_iterations = 50;
  double global_growth = 0.15;
  int max_global_frames = 500;
  double loss_px = 1.0;
  double focal_sigma = 0.005;
  double center_sigma = 0.003;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("local_frames", local_frames, 2, 50, "free ones of a local adjustment");
    table.AddNumber("running_max_iterations", running_max_iterations, 1, 200, "while a drive runs");
    table.AddNumber("final_max_iterations", final_max_iterations, 1, 1000, "at a session's end");
    table.AddNumber("global_growth", global_growth, 0.01, 10.0,
                    "a global one when frames or landmarks grew by this share");
    table.AddNumber("max_global_frames", max_global_frames, 10, 100000, "larger maps: by windows");
    table.AddNumber("loss_px", loss_px, 0.1, 20.0, "scale of the robust loss");
    table.AddNumber("focal_sigma", focal_sigma, 0.0, 0.1,
                    "of a calibration's focal length, relative; 0: calibrations are exact");
    table.AddNumber("center_sigma", center_sigma, 1e-6, 0.1, "of its centre, in focal lengths");
  }
};

struct PruneOptions {
  double max_error_px = 4.0;
  double final_error_sigmas = 6.0;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_error_px", max_error_px, 0.5, 50.0, "τ_r");
    table.AddNumber("final_error_sigmas", final_error_sigmas, 1.0, 20.0,
                    "in the final adjustment: of the robust spread");
  }
};

struct ScaleOptions {
  double min_distance_m = 0.3;
  double max_rotation_gap_deg = 2.0;
  double odometry_gain_sigma = 0.05;
  double sideways_sigma = 0.2;
  double camera_height_m = 0.0;
  double camera_height_sigma = 0.03;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("min_distance_m", min_distance_m, 0.05, 10.0, "length of a window");
    table.AddNumber("max_rotation_gap_deg", max_rotation_gap_deg, 0.1, 45.0,
                    "odometry and vision must agree that well");
    table.AddNumber("odometry_gain_sigma", odometry_gain_sigma, 0.001, 1.0,
                    "relative; averaging never goes below it");
    table.AddNumber("sideways_sigma", sideways_sigma, 0.0, 1.0,
                    "sideways beyond it, where the odometry's covariance tells none");
    table.AddNumber("camera_height_m", camera_height_m, 0.0, 10.0,
                    "over a flat floor, head as in the first keyframe; 0: not known");
    table.AddNumber("camera_height_sigma", camera_height_sigma, 0.001, 1.0, "relative");
  }
};

// How a drive is mapped.
struct MapperOptions {
  BootstrapOptions bootstrap;
  ResectOptions resect;
  TriangulateOptions triangulate;
  AdjustOptions adjust;
  PruneOptions prune;
  ScaleOptions scale;
  FilterF2Options f2;
  int max_weak_frames = 3;
  int max_weak_tries = 10;
  double pixel_sigma_px = 1.0;
  double sigma_size_px = 6.0;
  double sigma_exponent = 0.5;
  uint64_t seed = 1;

  void DescribeOptions(OptionTable& table) {
    table.AddGroup("bootstrap", bootstrap, "when two held frames may start a session (§3.7)");
    table.AddGroup("resect", resect, "where a frame sees known landmarks from: RANSAC");
    table.AddGroup("triangulate", triangulate, "tracks become landmarks");
    table.AddGroup("adjust", adjust, "bundle adjustment");
    table.AddGroup("prune", prune, "which observations go (§3.8)");
    table.AddGroup("scale", scale, "from wheel odometry, or the camera's height over the floor");
    table.AddGroup("f2", f2, "whether two landmarks of linked tracks are one (§3.6)");
    table.AddNumber("max_weak_frames", max_weak_frames, 0, 100, "in a row; more end the session");
    table.AddNumber("max_weak_tries", max_weak_tries, 1, 1000, "of a weak keyframe at later ones");
    table.AddNumber("pixel_sigma_px", pixel_sigma_px, 0.1, 20.0, "position of a small feature");
    table.AddNumber("sigma_size_px", sigma_size_px, 1.0, 100.0, "larger ones are less certain");
    table.AddNumber("sigma_exponent", sigma_exponent, 0.0, 2.0,
                    "sigma grows with (size / sigma_size_px) to this power");
    table.AddNumber("seed", seed, 0, kNoLimit, "");
  }
};

}  // namespace rovio_sfm
