#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/sim/tour/simulate_tour.h"
#include "rovio_sfm/sim/world/world.h"

namespace rovio_sfm::sim {

// A view with its true depth (from RenderDepth with the given step).
struct DepthView {
  Rigid3 world_from_camera;
  cv::Mat depth_m;
};

// Of every picture of a tour.
std::vector<DepthView> RenderDepths(const World& world, const Camera& camera,
                                    const SimulatedTour& tour, int step_px);

struct ViewOverlap {
  int first = 0, second = 0;     // indices of the views
  double covisible_share = 0.0;  // of the pixels, mean of both directions, 0 … 1
  double angle_rad = 0.0;        // between the optical axes
};

// The share of a's pixels whose points b sees too: inside its image and not hidden there.
double CovisibleShare(const Camera& camera, const DepthView& a, const DepthView& b, int step_px);

// How far the points that both see move from a's picture to b's, pixels, rising.
std::vector<double> FlowsBetween(const Camera& camera, const DepthView& a, const DepthView& b,
                                 int step_px);

// Pairs first < second of one list that share anything.
std::vector<ViewOverlap> FindOverlaps(const Camera& camera, const std::vector<DepthView>& views,
                                      int step_px);

// Pairs of one list with another that share anything.
std::vector<ViewOverlap> FindOverlaps(const Camera& camera, const std::vector<DepthView>& views,
                                      const std::vector<DepthView>& others, int step_px);

}  // namespace rovio_sfm::sim
