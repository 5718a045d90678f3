#include "rovio_sfm/sfm/estimate_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMinWindows = 3;

// One displacement, seen by the wheels and by the camera.
struct Window {
  double log_ratio = 0.0;  // log(metres / map units)
  double gain_sigma = 0.0;
};

std::optional<Window> MakeWindow(const ScaleSample& from, const ScaleSample& to,
                                 const EstimateScaleOptions& options) {
  const Eigen::Vector3d moved_m =
      to.odom_from_camera.translation - from.odom_from_camera.translation;
  const double moved_units = (OriginInA(to.cam_from_map) - OriginInA(from.cam_from_map)).norm();
  if (!(moved_units > 0.0)) return std::nullopt;
  const Eigen::Quaterniond by_wheels =
      to.odom_from_camera.rotation.conjugate() * from.odom_from_camera.rotation;
  const Eigen::Quaterniond by_camera =
      to.cam_from_map.rotation * from.cam_from_map.rotation.conjugate();
  if (RotationAngle(by_wheels * by_camera.conjugate()) > options.max_rotation_gap_rad) {
    return std::nullopt;
  }
  const double heading = 0.5 * (from.yaw_rad + to.yaw_rad);
  const double direction = std::atan2(moved_m.y(), moved_m.x()) - heading;
  Window window;
  window.log_ratio = std::log(moved_m.norm() / moved_units);
  // A gain lengthens the way by its part of the displacement along the displacement; that of
  // forward motion is a floor.
  const double of_both =
      std::hypot(options.gains.forward_sigma * std::pow(std::cos(direction), 2),
                 options.gains.sideways_sigma * std::pow(std::sin(direction), 2));
  window.gain_sigma = std::max(options.gains.forward_sigma, of_both);
  return window;
}

struct Windows {
  std::vector<Window> all;  // one from every sample; neighbours overlap
  size_t num_disjoint = 0;  // as many of them could be laid end to end
};

Windows MakeWindows(const std::vector<ScaleSample>& samples, const EstimateScaleOptions& options) {
  Windows windows;
  size_t end_of_disjoint = 0;
  for (size_t i = 0, j = 0; i < samples.size(); ++i) {
    for (j = std::max(j, i + 1); j < samples.size(); ++j) {
      const double moved_m =
          (samples[j].odom_from_camera.translation - samples[i].odom_from_camera.translation)
              .norm();
      if (moved_m >= options.min_distance_m) break;
    }
    if (j == samples.size()) break;
    const auto window = MakeWindow(samples[i], samples[j], options);
    if (!window) continue;
    windows.all.push_back(*window);
    if (i < end_of_disjoint) continue;
    ++windows.num_disjoint;
    end_of_disjoint = j;
  }
  return windows;
}

double WeightedMedian(std::vector<Window> windows) {
  std::stable_sort(windows.begin(), windows.end(),
                   [](const Window& a, const Window& b) { return a.log_ratio < b.log_ratio; });
  const auto weight = [](const Window& w) { return 1.0 / (w.gain_sigma * w.gain_sigma); };
  double total = 0.0;
  for (const Window& window : windows) total += weight(window);
  double sum = 0.0;
  for (const Window& window : windows) {
    sum += weight(window);
    if (sum >= 0.5 * total) return window.log_ratio;
  }
  return windows.back().log_ratio;
}

}  // namespace

std::optional<MapScale> EstimateScale(const std::vector<ScaleSample>& samples,
                                      const EstimateScaleOptions& options) {
  const auto [windows, num_disjoint] = MakeWindows(samples, options);
  if (windows.size() < kMinWindows) return std::nullopt;
  const double log_scale = WeightedMedian(windows);
  std::vector<double> deviations;
  double weight_sum = 0.0, gain_sum = 0.0;
  for (const Window& window : windows) {
    deviations.push_back(std::abs(window.log_ratio - log_scale));
    weight_sum += 1.0 / (window.gain_sigma * window.gain_sigma);
    gain_sum += 1.0 / window.gain_sigma;
  }
  const double scatter =
      1.4826 * Median(std::move(deviations)) / std::sqrt(static_cast<double>(num_disjoint));
  // The gains of all windows are one unknown each way, so they do not average out.
  const double gain_sigma = gain_sum / weight_sum;
  return MapScale{std::exp(log_scale), std::hypot(scatter, gain_sigma), "odometry"};
}

}  // namespace rovio_sfm
