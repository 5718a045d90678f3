#pragma once

#include <vector>

namespace rovio_sfm {

// The real roots of sum coefficients[i] x^i of degree 10 at most, ascending: isolated by the sign
// changes of Bernstein coefficients (Lane and Riesenfeld 1981), found by a safeguarded Newton
// iteration. Roots where the polynomial only touches zero may be missed. Empty for a constant.
std::vector<double> FindRealRoots(const std::vector<double>& coefficients);

}  // namespace rovio_sfm
