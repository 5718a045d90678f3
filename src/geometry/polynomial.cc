#include "rovio_sfm/geometry/polynomial.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {
namespace {

struct ValueAndSlope {
  double value = 0.0, slope = 0.0;
};

ValueAndSlope Evaluate(const double* coefficients, int degree, double x) {
  ValueAndSlope result{coefficients[degree], 0.0};
  for (int i = degree - 1; i >= 0; --i) {
    result.slope = result.slope * x + result.value;
    result.value = result.value * x + coefficients[i];
  }
  return result;
}

// The root between low and high, where the values have different signs; Newton, and bisection
// wherever Newton would leave the bracket. Ends with the first Newton step below last_step; the
// error then is of the order of its square.
double FindBracketedRoot(const double* coefficients, int degree, double low, double high,
                         bool rising, double last_step) {
  constexpr int kMaxSteps = 80;
  double x = 0.5 * (low + high);
  for (int step = 0; step < kMaxSteps; ++step) {
    const ValueAndSlope at = Evaluate(coefficients, degree, x);
    if (at.value == 0.0) return x;
    ((at.value < 0.0) == rising ? low : high) = x;
    double next = x - at.value / at.slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= last_step) return next;
    x = next;
  }
  return x;
}

// The roots of a polynomial within [-1, 1] from those of its derivative there.
void SplitAtExtrema(const double* coefficients, int degree, const std::vector<double>& extrema,
                    double last_step, std::vector<double>* roots) {
  roots->clear();
  double low = -1.0;
  double value_low = Evaluate(coefficients, degree, low).value;
  for (size_t i = 0; i <= extrema.size(); ++i) {
    const double high = i < extrema.size() ? extrema[i] : 1.0;
    const double value_high = Evaluate(coefficients, degree, high).value;
    if ((value_low < 0.0) != (value_high < 0.0)) {
      roots->push_back(
          FindBracketedRoot(coefficients, degree, low, high, value_low < 0.0, last_step));
    }
    low = high;
    value_low = value_high;
  }
}

// The roots within [-1, 1]: those of the derivatives, from the linear one up, bracket them.
std::vector<double> FindRootsInUnitInterval(const std::vector<double>& coefficients) {
  const int degree = static_cast<int>(coefficients.size()) - 1;
  std::vector<double> roots, extrema, derivative(coefficients.size());
  for (int order = degree - 1; order >= 0; --order) {
    for (int i = order; i <= degree; ++i) {
      double factor = 1.0;
      for (int k = 0; k < order; ++k) factor *= i - k;
      derivative[static_cast<size_t>(i - order)] = factor * coefficients[static_cast<size_t>(i)];
    }
    // Extrema only bracket what follows and need not be exact.
    SplitAtExtrema(derivative.data(), degree - order, extrema, order == 0 ? 1e-9 : 1e-3, &roots);
    extrema.swap(roots);
  }
  return extrema;
}

}  // namespace

std::vector<double> FindRealRoots(const std::vector<double>& coefficients) {
  if (coefficients.size() < 2) return {};
  std::vector<double> roots = FindRootsInUnitInterval(coefficients);
  // Roots outside are the reciprocals of the reversed polynomial's.
  const std::vector<double> reversed(coefficients.rbegin(), coefficients.rend());
  for (const double root : FindRootsInUnitInterval(reversed)) {
    if (std::abs(root) < 1.0 && std::abs(root) > 1e-12) roots.push_back(1.0 / root);
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

}  // namespace rovio_sfm
