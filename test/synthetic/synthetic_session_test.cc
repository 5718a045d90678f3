#include "synthetic/synthetic_session.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(SyntheticSession, HoldsTheWorldExactly) {
  SyntheticOptions options;
  options.num_points = 100;
  options.num_cams = 4;
  const SyntheticWorld world = MakeSyntheticWorld(options);
  const Session session = MakeMappedSession(world);
  EXPECT_EQ(CheckInvariants(session), "");
  EXPECT_EQ(session.keyframes().size(), 4u);
  EXPECT_GT(session.landmarks().size(), 40u);
  for (const auto& [id, landmark] : session.landmarks()) {
    for (const Observation& observation : landmark.observations) {
      const Keyframe& frame = session.keyframe(observation.frame);
      const Eigen::Vector3d x_in_cam = frame.cam_from_session * landmark.position;
      EXPECT_LT((x_in_cam.hnormalized() - frame.points[observation.feature]).norm(), 1e-12);
    }
  }
  EXPECT_TRUE(MakeSyntheticSession(world).landmarks().empty());
}

TEST(PerturbPose, MovesByAboutTheAskedAmount) {
  Rng rng(1);
  const Rigid3 pose{Eigen::Quaterniond(0.9, 0.1, 0.2, 0.1).normalized(), {1.0, 2.0, 3.0}};
  EXPECT_LT(PoseDistance(pose, PerturbPose(pose, 0.0, 0.0, rng)), 1e-12);
  const double distance = PoseDistance(pose, PerturbPose(pose, 0.01, 0.1, rng));
  EXPECT_GT(distance, 0.01);
  EXPECT_LT(distance, 1.0);
}

}  // namespace
}  // namespace rovio_sfm
