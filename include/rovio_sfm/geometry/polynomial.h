#pragma once

#include <vector>

namespace rovio_sfm {

// The real roots of sum coefficients[i] x^i, ascending; found by bracketing between the roots of
// the derivative and a safeguarded Newton iteration. Roots where the polynomial only touches zero
// may be missed. Empty for a constant.
std::vector<double> FindRealRoots(const std::vector<double>& coefficients);

}  // namespace rovio_sfm
