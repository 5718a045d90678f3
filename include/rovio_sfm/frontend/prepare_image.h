#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "rovio_sfm/features/flow.h"
#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// An image with everything that can be known of it alone.
struct PreparedImage {
  ImageEvent event;
  std::string refusal;  // why it cannot be used, naming the image; empty if it can
  cv::Mat bgr;          // raw, 8-bit
  FlowPyramid full;     // grey; only where light frames or a choice need it
  FlowPyramid small;    // the same at half size
  double sharpness = 0.0;
  std::shared_ptr<const FrameFeatures> features;  // null if they are found only on demand
};

// The pure first half of the frontend: checks, decodes, and in mode every also extracts. May run
// ahead on any thread. Untrusted bytes and cameras end in a refusal, never in a crash.
PreparedImage PrepareImage(const ImageEvent& event, const FrontendOptions& options);

// Denoises and extracts (steps 3 and 4 of §5.1 in the design).
std::shared_ptr<const FrameFeatures> FindFeatures(const cv::Mat& bgr, const Camera& camera,
                                                  const FrontendOptions& options);

}  // namespace rovio_sfm
