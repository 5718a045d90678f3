#include "rovio_sfm/mapping/bootstrap.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_drive.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

std::deque<FrameEvent> Held(const SyntheticDriveOptions& options, size_t count) {
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  return {drive.events.begin(), drive.events.begin() + static_cast<std::ptrdiff_t>(count)};
}

Session NoAliases() { return Session({1}, {"rovio", 1, 0}, MakeSyntheticCamera()); }

// The angle of a pair of the circle's cameras and the direction of its motion.
void ExpectTruePair(const BootstrapPair& pair, const SyntheticDriveOptions& options) {
  const SyntheticWorld world = MakeSyntheticWorld(options.world);
  Rigid3 truth = world.cams_from_map[pair.second] * Inverse(world.cams_from_map[pair.first]);
  truth.translation.normalize();
  EXPECT_LT(PoseDistance(pair.second_from_first, truth), 1e-5);
}

TEST(FindBootstrapPair, TakesAPairOfTheWishedAngleWithTheTrueMotion) {
  const auto pair = FindBootstrapPair(Held({}, 8), NoAliases(), {}, 1);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->first, 0u);
  EXPECT_EQ(pair->second, 7u);
  EXPECT_GE(pair->angle_rad, 16.0 * M_PI / 180.0);
  EXPECT_GE(pair->num_inliers, 100u);
  ExpectTruePair(*pair, {});
}

TEST(FindBootstrapPair, SettlesForTheWidestBelowTheWishedAngle) {
  BootstrapOptions options;
  options.wished_angle_deg = 60.0;
  const auto pair = FindBootstrapPair(Held({}, 5), NoAliases(), options, 1);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->first, 0u);
  EXPECT_EQ(pair->second, 4u);
}

TEST(FindBootstrapPair, MeasuresTheAngleOfTheWidestPoints) {
  SyntheticDriveOptions drive;
  drive.world.num_points = 500;
  BootstrapOptions all, few;
  few.min_inliers = 20;
  const auto held = Held(drive, 3);
  const auto of_all = FindBootstrapPair(held, NoAliases(), all, 1);
  const auto of_few = FindBootstrapPair(held, NoAliases(), few, 1);
  ASSERT_TRUE(of_all && of_few);
  EXPECT_GT(of_few->num_inliers, 150u);  // more than either counts
  EXPECT_GT(of_few->angle_rad, 1.05 * of_all->angle_rad);
}

TEST(FindBootstrapPair, AnswersNothingForTooFewFrames) {
  EXPECT_FALSE(FindBootstrapPair({}, NoAliases(), {}, 1));
  EXPECT_FALSE(FindBootstrapPair(Held({}, 1), NoAliases(), {}, 1));
}

TEST(FindBootstrapPair, WaitsForParallax) {
  EXPECT_FALSE(FindBootstrapPair(Held({}, 2), NoAliases(), {60, 100, 8.0}, 1));
}

TEST(FindBootstrapPair, RefusesRotationOnTheSpot) {
  SyntheticDriveOptions options;
  options.world.motion = SyntheticMotion::kRotation;
  options.world.noise_px = 0.5;
  EXPECT_FALSE(FindBootstrapPair(Held(options, 6), NoAliases(), {}, 1));
}

TEST(FindBootstrapPair, RefusesAPlane) {
  SyntheticDriveOptions options;
  options.world.scene = SyntheticScene::kPlane;
  EXPECT_FALSE(FindBootstrapPair(Held(options, 6), NoAliases(), {}, 1));
}

TEST(FindBootstrapPair, RefusesTooFewCommonTracks) {
  SyntheticDriveOptions options;
  options.world.num_points = 60;
  EXPECT_FALSE(FindBootstrapPair(Held(options, 8), NoAliases(), {}, 1));
  SyntheticDriveOptions cut;
  cut.cut = 7;
  EXPECT_FALSE(FindBootstrapPair(Held(cut, 8), NoAliases(), {}, 1));
}

TEST(FindBootstrapPair, SeesThroughLinkedTracks) {
  SyntheticDriveOptions options;
  options.blind = {7};
  const auto held = Held(options, 8);
  EXPECT_FALSE(FindBootstrapPair(held, NoAliases(), {}, 1));
  options.with_late_links = true;
  Session aliases = NoAliases();
  for (const TrackLink& link : MakeSyntheticDrive(options).events[8].links) {
    aliases.UniteTracks(link.a, link.b);
  }
  EXPECT_TRUE(FindBootstrapPair(held, aliases, {}, 1));
}

TEST(FindBestBootstrapPair, FindsThePairThatIsNotTheNewest) {
  SyntheticDriveOptions options;
  options.cut = 7;
  const auto pair = FindBestBootstrapPair(Held(options, 8), NoAliases(), {}, 1);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->first, 0u);
  EXPECT_EQ(pair->second, 6u);
  ExpectTruePair(*pair, {});
  EXPECT_FALSE(FindBestBootstrapPair({}, NoAliases(), {}, 1));
}

TEST(FindBestBootstrapPair, LooksAtTwentyOfManyHeldFrames) {
  SyntheticDriveOptions options;
  std::deque<FrameEvent> held;  // a robot that stands, then drives a little
  for (const FrameEvent& event : Held(options, 8)) {
    const int num_repeats = event.id.index == 0 ? 100 : 3;
    for (int i = 0; i < num_repeats; ++i) held.push_back(event);
  }
  const auto pair = FindBestBootstrapPair(held, NoAliases(), {}, 1);
  ASSERT_TRUE(pair);
  EXPECT_EQ(held[pair->first].id.index, 0u);
  EXPECT_EQ(pair->second, held.size() - 1);
}

}  // namespace
}  // namespace rovio_sfm
