#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/sim/tour/audit_figure.h"
#include "rovio_sfm/sim/tour/simulate_tour.h"
#include "rovio_sfm/sim/world/develop_image.h"
#include "rovio_sfm/sim/world/render_image.h"

namespace rovio_sfm::sim {

// The share of 16 x 16 px blocks whose detail (standard deviation, grey levels) is below 10, which
// is what the robot's noise hides.
double PlainShare(const cv::Mat& bgr);

// The noise that a picture of a flat grey surface has after developing, JPEG and decoding.
struct NoiseFigures {
  double sigma = 0.0;        // grey levels, root mean square of the channels
  double correlation = 0.0;  // of the brightness of neighbours in a row
};
NoiseFigures DecodedNoise(const DevelopOptions& options);

struct AuditTourOptions {
  int num_pictures = 9;  // rendered for the figures that need them, spread over the tour
  int depth_step_px = 16;
};

// What the camera sees on a tour, and how the robot moves and errs.
AuditFigures AuditTour(const ImageRenderer& renderer, const TourSpec& spec, const SlipOptions& slip,
                       const DevelopOptions& develop, uint64_t seed,
                       const AuditTourOptions& options);

}  // namespace rovio_sfm::sim
