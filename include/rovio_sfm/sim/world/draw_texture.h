#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/sim/world/texture_spec.h"

namespace rovio_sfm::sim {

// CV_8UC3, RGB. The same spec gives the same bytes. Needs a valid spec.
cv::Mat DrawTexture(const TextureSpec& spec);

}  // namespace rovio_sfm::sim
