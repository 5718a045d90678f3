#include "rovio_sfm/sim/tour/audit.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/sim/tour/audit_world.h"
#include "rovio_sfm/sim/tour/tour.h"
#include "rovio_sfm/sim/world/load_world.h"

namespace rovio_sfm::sim {
namespace {

std::string BoundsOf(const AuditFigure& figure) {
  std::ostringstream out;
  if (std::isinf(figure.high)) {
    out << ">= " << figure.low;
  } else {
    out << figure.low << " … " << figure.high;
  }
  return out.str();
}

}  // namespace

AuditFigures Audit(const AuditOptions& options) {
  const TourSpec spec = WithLongerSteps(
      LoadTour(options.config_folder + "/tours/" + options.tour + ".yaml"), options.steps);
  if (!options.world.empty() && spec.world != options.world) {
    throw std::runtime_error("tour " + options.tour + " is of world " + spec.world + ", not of " +
                             options.world);
  }
  const World world(LoadWorld(options.config_folder + "/worlds/" + spec.world + ".yaml"));
  const ImageRenderer renderer(world, RovioCamera(), options.render);
  AuditFigures figures = AuditWorld(world);
  const AuditFigures tour =
      AuditTour(renderer, spec, options.slip, options.develop, options.seed, options.audit);
  figures.insert(figures.end(), tour.begin(), tour.end());
  return figures;
}

bool PrintAudit(const AuditFigures& figures, std::ostream& out) {
  bool all_hold = true;
  for (const AuditFigure& figure : figures) {
    all_hold = all_hold && figure.Holds();
    out << (figure.Holds() ? "holds        " : "falls short  ") << std::left << std::setw(58)
        << figure.name << ' ' << std::setprecision(4) << std::setw(9) << figure.value << " ("
        << BoundsOf(figure) << ")\n";
  }
  return all_hold;
}

}  // namespace rovio_sfm::sim
