#include "rovio_sfm/geometry/polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr int kMaxDegree = 10;
constexpr int kMaxSplits = 40;  // of [0, 1]: roots nearer to each other than 2^-40 may be missed
constexpr double kLastStep = 1e-9;

// Coefficients by power, or in Bernstein's basis on an interval.
using Coefficients = std::array<double, kMaxDegree + 1>;

struct Polynomial {
  Coefficients coefficients{};
  int degree = 0;
};

struct ValueAndSlope {
  double value = 0.0, slope = 0.0;
};

ValueAndSlope Evaluate(const Polynomial& polynomial, double x) {
  ValueAndSlope result;
  for (int i = polynomial.degree; i >= 0; --i) {
    result.slope = result.slope * x + result.value;
    result.value = result.value * x + polynomial.coefficients[static_cast<size_t>(i)];
  }
  return result;
}

// The root between low and high, where the values have different signs; Newton, and bisection
// wherever Newton would leave the bracket. Ends with the first Newton step below kLastStep; the
// error then is of the order of its square.
double FindBracketedRoot(const Polynomial& polynomial, double low, double high, bool rising) {
  constexpr int kMaxSteps = 80;
  double x = 0.5 * (low + high);
  for (int step = 0; step < kMaxSteps; ++step) {
    const ValueAndSlope at = Evaluate(polynomial, x);
    if (at.value == 0.0) return x;
    ((at.value < 0.0) == rising ? low : high) = x;
    double next = x - at.value / at.slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= kLastStep) return next;
    x = next;
  }
  return x;
}

// On [0, 1]: b_j = sum_i C(j, i) / C(n, i) a_i.
Coefficients ToBernstein(const Polynomial& polynomial) {
  Coefficients b{};
  const auto count = static_cast<size_t>(polynomial.degree) + 1;
  double binomial = 1.0;
  for (size_t i = 0; i < count; ++i) {
    b[i] = polynomial.coefficients[i] / binomial;
    binomial *= static_cast<double>(count - 1 - i) / static_cast<double>(i + 1);
  }
  for (size_t i = 1; i < count; ++i) {
    for (size_t j = count - 1; j >= i; --j) b[j] += b[j - 1];
  }
  return b;
}

int CountSignChanges(const Coefficients& b, int degree) {
  int count = 0;
  for (size_t i = 0; i < static_cast<size_t>(degree); ++i) {
    count += (b[i] < 0.0) != (b[i + 1] < 0.0);
  }
  return count;
}

// Halves an interval (de Casteljau): b keeps the upper half; returns the lower one.
Coefficients SplitOff(Coefficients* b, int degree) {
  Coefficients lower{};
  const auto last = static_cast<size_t>(degree);
  for (size_t i = 0; i <= last; ++i) {
    lower[i] = (*b)[0];
    for (size_t j = 0; j + i < last; ++j) (*b)[j] = 0.5 * ((*b)[j] + (*b)[j + 1]);
  }
  return lower;
}

// An interval has at most as many roots as its Bernstein coefficients change their sign, and as
// many but for pairs (Descartes): it is halved until that is 0 or 1.
void AddRoots(const Polynomial& polynomial, Coefficients b, double low, double high, int num_splits,
              std::vector<double>* roots) {
  const int num_changes = CountSignChanges(b, polynomial.degree);
  if (num_changes == 0) return;
  if (num_changes == 1 || num_splits == kMaxSplits) {
    const bool rising = b[0] < 0.0;
    if (num_changes % 2 == 1) roots->push_back(FindBracketedRoot(polynomial, low, high, rising));
    return;
  }
  const double middle = 0.5 * (low + high);
  const Coefficients lower = SplitOff(&b, polynomial.degree);
  AddRoots(polynomial, lower, low, middle, num_splits + 1, roots);
  AddRoots(polynomial, b, middle, high, num_splits + 1, roots);
}

std::vector<double> FindRootsInUnitInterval(const Polynomial& polynomial) {
  std::vector<double> roots;
  AddRoots(polynomial, ToBernstein(polynomial), 0.0, 1.0, 0, &roots);
  return roots;
}

// Of p(-x).
Polynomial Mirror(Polynomial polynomial) {
  for (size_t i = 1; i <= static_cast<size_t>(polynomial.degree); i += 2) {
    polynomial.coefficients[i] = -polynomial.coefficients[i];
  }
  return polynomial;
}

// Of x^n p(1 / x).
Polynomial Reverse(Polynomial polynomial) {
  const auto begin = polynomial.coefficients.begin();
  std::reverse(begin, begin + polynomial.degree + 1);
  return polynomial;
}

}  // namespace

std::vector<double> FindRealRoots(const std::vector<double>& coefficients) {
  ROVIO_CHECK(coefficients.size() <= kMaxDegree + 1);
  Polynomial polynomial;
  std::copy(coefficients.begin(), coefficients.end(), polynomial.coefficients.begin());
  for (size_t i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] != 0.0) polynomial.degree = static_cast<int>(i);
  }
  if (polynomial.degree == 0) return {};
  std::vector<double> roots;
  for (const double sign : {1.0, -1.0}) {
    for (const double root : FindRootsInUnitInterval(polynomial)) roots.push_back(sign * root);
    // Roots outside are the reciprocals of the reversed polynomial's.
    for (const double root : FindRootsInUnitInterval(Reverse(polynomial))) {
      if (root < 1.0 && root > 1e-12) roots.push_back(sign / root);
    }
    polynomial = Mirror(polynomial);
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

}  // namespace rovio_sfm
