#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "rovio_sfm/sim/tour/audit_figure.h"
#include "rovio_sfm/sim/tour/audit_tour.h"

namespace rovio_sfm::sim {

struct AuditOptions {
  std::string config_folder;  // holds worlds/ and tours/
  std::string world;          // name of a file there, without .yaml; empty: the tour's own
  std::string tour;           // name of a file there, without .yaml
  uint64_t seed = 1;
  double steps = 1.0;  // of WithLongerSteps
  RenderOptions render;
  DevelopOptions develop;
  SlipOptions slip;
  AuditTourOptions audit;
};

// All figures of a world and a tour through it; throws std::runtime_error that names what is wrong
// with the files, or that the tour is of another world.
AuditFigures Audit(const AuditOptions& options);

// One line a figure, with bounds and "holds" or "falls short"; true if all hold.
bool PrintAudit(const AuditFigures& figures, std::ostream& out);

}  // namespace rovio_sfm::sim
