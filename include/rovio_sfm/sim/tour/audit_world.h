#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/sim/tour/audit_figure.h"
#include "rovio_sfm/sim/world/world.h"

namespace rovio_sfm::sim {

// The exponent by which a texture's amplitude falls with frequency (natural pictures: about -1;
// white noise: 0), fitted between the periods of 4 and 64 px. rgb: at least 128 px each way.
double SpectrumSlope(const cv::Mat& rgb);

// Textures, repeats, thin parts, shine and lamps of a world.
AuditFigures AuditWorld(const World& world);

}  // namespace rovio_sfm::sim
