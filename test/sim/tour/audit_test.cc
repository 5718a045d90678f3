#include "rovio_sfm/sim/tour/audit.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace rovio_sfm::sim {
namespace {

AuditOptions Reduced(const std::string& world, const std::string& tour) {
  AuditOptions options;
  options.config_folder = ROVIO_SOURCE_DIR "/config";
  options.world = world;
  options.tour = tour;
  options.audit.num_pictures = 3;
  options.audit.depth_step_px = 32;
  return options;
}

// The real worlds take seconds to build; scripts/accept audits every tour in full.
TEST(Audit, TheLaboratoryHolds) {
  std::ostringstream report;
  EXPECT_TRUE(PrintAudit(Audit(Reduced("laboratory", "visionlab")), report)) << report.str();
}

TEST(Audit, RefusesATourOfAnotherWorld) {
  EXPECT_THROW(Audit(Reduced("engine_room", "visionlab")), std::runtime_error);
}

TEST(PrintAudit, SaysWhatFallsShort) {
  std::ostringstream out;
  EXPECT_FALSE(PrintAudit({AtLeast("good", 2, 1), Within("bad", 9, 1, 2)}, out));
  EXPECT_NE(out.str().find("holds        good"), std::string::npos);
  EXPECT_NE(out.str().find("falls short  bad"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm::sim
