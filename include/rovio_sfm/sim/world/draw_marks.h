#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "rovio_sfm/sim/world/texture_spec.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {

// Draws one of KnownMarks on the image (CV_8UC3, RGB), as dense as spec.density says.
void DrawMarks(const std::string& mark, const TextureSpec& spec, Rng& rng, cv::Mat* image);

}  // namespace rovio_sfm::sim
