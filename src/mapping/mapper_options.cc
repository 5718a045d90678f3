#include "rovio_sfm/mapping/mapper_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool BootstrapOptions::IsValid(std::string* error) const {
  OptionChecker checker("bootstrap", error);
  checker.Range("max_held_frames", max_held_frames, 4, 1000);
  checker.Range("min_inliers", min_inliers, 20, 10000);
  checker.Range("min_angle_deg", min_angle_deg, 0.5, 45.0);
  checker.Range("wished_angle_deg", wished_angle_deg, min_angle_deg, 60.0);
  checker.Range("patience", patience, 1, 1000);
  checker.Range("hurry_after", hurry_after, 2, 1000);
  checker.Range("hurried_angle_deg", hurried_angle_deg, 0.5, min_angle_deg);
  return checker.Passed();
}

bool ResectOptions::IsValid(std::string* error) const {
  OptionChecker checker("resect", error);
  checker.Range("threshold_px", threshold_px, 0.5, 50.0);
  checker.Range("min_inliers", min_inliers, 6, 1000);
  checker.Range("max_iterations", max_iterations, 10, 100000);
  return checker.Passed();
}

bool TriangulateOptions::IsValid(std::string* error) const {
  OptionChecker checker("triangulate", error);
  checker.Range("min_parallax_deg", min_parallax_deg, 0.1, 30.0);
  checker.Range("max_error_px", max_error_px, 0.5, 50.0);
  return checker.Passed();
}

bool AdjustOptions::IsValid(std::string* error) const {
  OptionChecker checker("adjust", error);
  checker.Range("local_frames", local_frames, 2, 50);
  checker.Range("running_max_iterations", running_max_iterations, 1, 200);
  checker.Range("final_max_iterations", final_max_iterations, 1, 1000);
  checker.Range("global_growth", global_growth, 0.01, 10.0);
  checker.Range("max_global_frames", max_global_frames, 10, 100000);
  checker.Range("loss_px", loss_px, 0.1, 20.0);
  return checker.Passed();
}

bool PruneOptions::IsValid(std::string* error) const {
  OptionChecker checker("prune", error);
  checker.Range("max_error_px", max_error_px, 0.5, 50.0);
  checker.Range("final_error_sigmas", final_error_sigmas, 1.0, 20.0);
  return checker.Passed();
}

bool ScaleOptions::IsValid(std::string* error) const {
  OptionChecker checker("scale", error);
  checker.Range("min_distance_m", min_distance_m, 0.05, 10.0);
  checker.Range("max_rotation_gap_deg", max_rotation_gap_deg, 0.1, 45.0);
  checker.Range("odometry_gain_sigma", odometry_gain_sigma, 0.001, 1.0);
  checker.Range("sideways_sigma", sideways_sigma, 0.0, 1.0);
  checker.Range("camera_height_m", camera_height_m, 0.0, 10.0);
  checker.Range("camera_height_sigma", camera_height_sigma, 0.001, 1.0);
  return checker.Passed();
}

bool MapperOptions::IsValid(std::string* error) const {
  OptionChecker checker("mapping", error);
  checker.Nested(bootstrap);
  checker.Nested(resect);
  checker.Nested(triangulate);
  checker.Nested(adjust);
  checker.Nested(prune);
  checker.Nested(scale);
  checker.Nested(f2);
  checker.Range("max_weak_frames", max_weak_frames, 0, 100);
  checker.Range("max_weak_tries", max_weak_tries, 1, 1000);
  checker.Range("pixel_sigma_px", pixel_sigma_px, 0.1, 20.0);
  checker.Range("sigma_size_px", sigma_size_px, 1.0, 100.0);
  checker.Range("sigma_exponent", sigma_exponent, 0.0, 2.0);
  return checker.Passed();
}

}  // namespace rovio_sfm
