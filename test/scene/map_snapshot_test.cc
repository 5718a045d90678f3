#include "rovio_sfm/scene/map_snapshot.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

SessionSnapshot OneFrame(const Rigid3& cam_from_session) {
  FrameBlock block(1);
  block[0].cam_from_session = cam_from_session;
  SessionSnapshot session;
  session.frames = {std::make_shared<const FrameBlock>(std::move(block))};
  return session;
}

Rigid3 SomePose() {
  return {Eigen::Quaterniond(0.8, 0.1, -0.4, 0.3).normalized(), {1.0, -2.0, 0.5}};
}

// A point in the session that lies at x_in_cam for the first frame.
Eigen::Vector3d InSession(const Rigid3& cam_from_session, const Eigen::Vector3d& x_in_cam) {
  return Inverse(cam_from_session) * x_in_cam;
}

void ExpectNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  EXPECT_LT((a - b).norm(), 1e-9) << a.transpose() << " instead of " << b.transpose();
}

TEST(LevelFromSession, AnswersNothingWithoutFrames) {
  EXPECT_FALSE(LevelFromSession({}).has_value());
}

TEST(LevelFromSession, LooksAlongXWithZUp) {
  const auto level = LevelFromSession(OneFrame(SomePose()));
  ASSERT_TRUE(level);
  ExpectNear(*level * InSession(SomePose(), {0, 0, 2}), {2, 0, 0});
  ExpectNear(*level * InSession(SomePose(), {1, 0, 0}), {0, -1, 0});
  ExpectNear(*level * InSession(SomePose(), {0, 1, 0}), {0, 0, -1});
}

TEST(LevelFromSession, TakesTheCameraAsPitchedDown) {
  const auto level = LevelFromSession(OneFrame(SomePose()), 0.2);
  ASSERT_TRUE(level);
  const Eigen::Vector3d forward(std::cos(0.2), 0.0, -std::sin(0.2));
  ExpectNear(*level * InSession(SomePose(), {0, 0, 1}), forward);
}

TEST(LevelFromSession, StandsOnTheFloorOfTheFirstFrameWhoseHeadIsKnown) {
  const Rigid3 base_from_camera{Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.1, 0.0, 0.25}};
  FrameBlock block(3);
  for (int i = 0; i < 3; ++i) {
    block[static_cast<size_t>(i)].cam_from_session = SomePose();
    block[static_cast<size_t>(i)].cam_from_session.translation.z() -= 0.1 * i;
  }
  block[1].base_from_camera = block[2].base_from_camera = base_from_camera;
  SessionSnapshot session;
  session.frames = {std::make_shared<const FrameBlock>(block)};
  session.scale = MapScale{1.0, 0.01, "odometry"};
  const auto level = LevelFromSession(session);
  ASSERT_TRUE(level);
  ExpectNear(*level * InSession(block[1].cam_from_session, {0, 0, 0}),
             base_from_camera.translation);
}

TEST(LevelFromSession, IsMetricAndHasTheLeverArmWithAScale) {
  SessionSnapshot session = OneFrame(SomePose());
  const Rigid3 base_from_camera{Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.1, 0.0, 0.25}};
  auto block = std::make_shared<FrameBlock>(*session.frames[0]);
  block->front().base_from_camera = base_from_camera;
  session.frames[0] = block;
  session.scale = MapScale{0.5, 0.01, "odometry"};
  const auto level = LevelFromSession(session);
  ASSERT_TRUE(level);
  ExpectNear(*level * InSession(SomePose(), {0, 0, 2}),
             base_from_camera * Eigen::Vector3d(0, 0, 1));
  session.scale.reset();
  ExpectNear(*LevelFromSession(session) * InSession(SomePose(), {0, 0, 0}), {0, 0, 0});
}

}  // namespace
}  // namespace rovio_sfm
