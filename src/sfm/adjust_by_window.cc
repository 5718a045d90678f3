#include "rovio_sfm/sfm/adjust_by_window.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

// A part of a problem, and which camera and point of the whole each entry stands for.
struct Window {
  BundleProblem problem;
  std::vector<uint32_t> cameras, points;
};

// The points that the cameras first … end - 1 see.
std::vector<bool> SeenBy(const BundleProblem& whole, size_t first, size_t end) {
  std::vector<bool> seen(whole.points.size(), false);
  for (const BundleObservation& observation : whole.observations) {
    if (observation.camera >= first && observation.camera < end) seen[observation.point] = true;
  }
  return seen;
}

Window Cut(const BundleProblem& whole, size_t first, size_t end) {
  const std::vector<bool> seen = SeenBy(whole, first, end);
  std::vector<uint32_t> camera_in(whole.cameras.size(), kNone);
  std::vector<uint32_t> point_in(whole.points.size(), kNone);
  Window window;
  for (const BundleObservation& observation : whole.observations) {
    if (!seen[observation.point]) continue;
    uint32_t& camera = camera_in[observation.camera];
    if (camera == kNone) {
      camera = static_cast<uint32_t>(window.cameras.size());
      window.cameras.push_back(observation.camera);
      window.problem.cameras.push_back(whole.cameras[observation.camera]);
      const bool inside = observation.camera >= first && observation.camera < end;
      window.problem.cameras.back().fixed |= !inside || observation.camera == 0;
    }
    uint32_t& point = point_in[observation.point];
    if (point == kNone) {
      point = static_cast<uint32_t>(window.points.size());
      window.points.push_back(observation.point);
      window.problem.points.push_back(whole.points[observation.point]);
    }
    window.problem.observations.push_back(
        {camera, point, observation.sigma, observation.x_normalized});
  }
  return window;
}

void PutBack(const Window& window, BundleProblem* whole) {
  for (size_t i = 0; i < window.cameras.size(); ++i) {
    whole->cameras[window.cameras[i]].cam_from_map = window.problem.cameras[i].cam_from_map;
  }
  for (size_t i = 0; i < window.points.size(); ++i) {
    whole->points[window.points[i]] = window.problem.points[i];
  }
}

// The first cameras of the windows, forward and then back.
std::vector<size_t> WindowStarts(size_t num_cameras, size_t size) {
  std::vector<size_t> starts;
  for (size_t start = 0; start + size < num_cameras; start += size / 2) starts.push_back(start);
  starts.push_back(num_cameras - size);
  for (size_t i = starts.size() - 1; i-- > 0;) starts.push_back(starts[i]);
  return starts;
}

void AddUp(const BundleReport& part, BundleReport* total) {
  if (!part.usable) {
    total->message = part.message;
    return;
  }
  total->usable = true;
  total->iterations += part.iterations;
  total->initial_cost += part.initial_cost;
  total->final_cost += part.final_cost;
}

}  // namespace

BundleReport AdjustByWindow(BundleProblem* problem, const BundleOptions& options,
                            size_t max_cameras) {
  ROVIO_CHECK(max_cameras >= 2);
  if (problem->cameras.size() <= max_cameras) return AdjustBundle(problem, options);
  BundleReport total;
  for (const size_t start : WindowStarts(problem->cameras.size(), max_cameras)) {
    Window window = Cut(*problem, start, start + max_cameras);
    const BundleReport report = AdjustBundle(&window.problem, options);
    AddUp(report, &total);
    if (report.usable) PutBack(window, problem);
  }
  return total;
}

}  // namespace rovio_sfm
