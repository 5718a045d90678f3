#pragma once

#include <limits>
#include <string>
#include <vector>

namespace rovio_sfm::sim {

// One line of the audit (design.md §5.6): a figure and the bounds that keep the simulator honest.
struct AuditFigure {
  std::string name;  // what was measured, with its unit
  double value = 0.0;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool Holds() const { return value >= low && value <= high; }
};

using AuditFigures = std::vector<AuditFigure>;

inline AuditFigure AtLeast(const std::string& name, double value, double low) {
  return {name, value, low, std::numeric_limits<double>::infinity()};
}

inline AuditFigure Within(const std::string& name, double value, double low, double high) {
  return {name, value, low, high};
}

}  // namespace rovio_sfm::sim
