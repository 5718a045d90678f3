#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "rovio_sfm/sim/world/texture_spec.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {

// Printed matter for DrawMarks: each draws on the image (CV_8UC3, RGB), as dense as spec.density.
void DrawText(const TextureSpec& spec, Rng& rng, cv::Mat* image);
void DrawPosters(const TextureSpec& spec, Rng& rng, cv::Mat* image);
void DrawLabels(const TextureSpec& spec, Rng& rng, cv::Mat* image);
void DrawBooks(const TextureSpec& spec, Rng& rng, cv::Mat* image);

// A colour of printing ink, from dark to saturated to pale.
cv::Scalar RandomColor(Rng& rng);

}  // namespace rovio_sfm::sim
