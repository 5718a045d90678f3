#include "rovio_sfm/sim/world/mover.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm::sim {
namespace {

MoverSpec WalkOfTwoMetres() {
  MoverSpec spec;
  spec.world = "person";
  spec.from_m = {1.0, 1.0};
  spec.to_m = {1.0, 3.0};
  spec.speed_m_s = 0.5;
  return spec;
}

TEST(Movers, WalkToAndFroAndFaceWhereTheyGo) {
  const MoverSpec spec = WalkOfTwoMetres();
  const auto ahead = [&](double time_s) {
    return Eigen::Vector3d(PlaceOfMover(spec, time_s).rotation * Eigen::Vector3d::UnitX());
  };
  EXPECT_NEAR(PlaceOfMover(spec, 0.0).translation.y(), 1.0, 1e-12);
  EXPECT_NEAR(PlaceOfMover(spec, 2.0).translation.y(), 2.0, 1e-12);
  EXPECT_NEAR(ahead(2.0).y(), 1.0, 1e-12);
  EXPECT_NEAR(PlaceOfMover(spec, 6.0).translation.y(), 2.0, 1e-12);
  EXPECT_NEAR(ahead(6.0).y(), -1.0, 1e-12);
  EXPECT_NEAR(PlaceOfMover(spec, 9.0).translation.y(), 1.5, 1e-12);
}

TEST(Movers, RefuseWhoCannotWalk) {
  MoverSpec spec = WalkOfTwoMetres();
  std::string error;
  EXPECT_TRUE(spec.IsValid(&error)) << error;
  spec.to_m = spec.from_m;
  EXPECT_FALSE(spec.IsValid(&error));
  EXPECT_NE(error.find("way from from_m to to_m"), std::string::npos) << error;
  spec = WalkOfTwoMetres();
  spec.world = "../person";
  EXPECT_FALSE(spec.IsValid(nullptr));
}

TEST(Movers, NameTheWorldThatIsMissing) {
  try {
    Movers({WalkOfTwoMetres()}, "/nowhere");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/person.yaml"), std::string::npos);
  }
}

TEST(Movers, NobodyMovesByDefault) {
  EXPECT_TRUE(Movers().empty());
  EXPECT_TRUE(Movers().At(3.0).empty());
}

}  // namespace
}  // namespace rovio_sfm::sim
