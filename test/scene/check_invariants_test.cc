#include <gtest/gtest.h>

#include <limits>

#include "rovio_sfm/scene/session.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

TEST(CheckInvariants, HoldsForAnEmptySession) {
  EXPECT_EQ(CheckInvariants(Session({1}, {"rovio", 1, 0}, MakeSyntheticCamera())), "");
}

TEST(CheckInvariants, HoldsForAMappedWorld) {
  SyntheticOptions options;
  options.num_points = 50;
  EXPECT_EQ(CheckInvariants(MakeMappedSession(MakeSyntheticWorld(options))), "");
}

TEST(CheckInvariants, NamesALandmarkThatIsNotFinite) {
  SyntheticOptions options;
  options.num_points = 50;
  Session session = MakeMappedSession(MakeSyntheticWorld(options));
  const TrackId track = session.landmarks().begin()->first;
  session.SetPosition(track, {0.0, std::numeric_limits<double>::quiet_NaN(), 1.0});
  EXPECT_EQ(CheckInvariants(session),
            "track " + std::to_string(track) + " has a landmark that is not finite");
}

}  // namespace
}  // namespace rovio_sfm
