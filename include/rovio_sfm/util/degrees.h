#pragma once

#include <cmath>

namespace rovio_sfm {

constexpr double Radians(double degrees) { return degrees * M_PI / 180.0; }
constexpr double Degrees(double radians) { return radians * 180.0 / M_PI; }

}  // namespace rovio_sfm
