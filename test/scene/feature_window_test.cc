#include "rovio_sfm/scene/feature_window.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "rovio_sfm/scene/memory_frame_store.h"
#include "synthetic/synthetic_drive.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

TEST(FeatureGrid, FindsEveryPointOfTheWindow) {
  Rng rng(3);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(rng.Uniform(-0.6, 0.6), rng.Uniform(-0.4, 0.4));
  const double radius = 0.03;
  const FeatureGrid grid(points, radius);
  for (const Eigen::Vector2d& centre : {points[0], points[99], Eigen::Vector2d(0.1, -0.2)}) {
    const std::vector<uint32_t> near = grid.Near(centre);
    for (uint32_t i = 0; i < points.size(); ++i) {
      if ((points[i] - centre).norm() > radius) continue;
      EXPECT_NE(std::find(near.begin(), near.end(), i), near.end());
    }
  }
}

struct WindowSetup {
  WindowSetup() : session(MakeMappedSession(drive.world)), reader(store, drive.events[0].id.drive) {
    for (const FrameEvent& event : drive.events) store.Put(event.id, event.features);
  }

  FeatureWindow Window(const FeatureGrid& grid) {
    return {session.keyframe(5), grid, *reader.Of(5), 0.02};
  }

  SyntheticDrive drive = MakeSyntheticDrive({});
  Session session;
  MemoryFrameStore store;
  DescriptorReader reader;
};

TEST(FindFeature, FindsTheFeatureThatLooksAlike) {
  WindowSetup setup;
  const Keyframe& frame = setup.session.keyframe(5);
  const FeatureGrid grid(frame.points, 0.02);
  const auto found =
      FindFeature(setup.Window(grid), frame.points[7], setup.reader.Row({5, 7}, 128));
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, 7u);
}

TEST(FindFeature, FindsNothingThatLooksDifferentOrIsFarAway) {
  WindowSetup setup;
  const Keyframe& frame = setup.session.keyframe(5);
  const FeatureGrid grid(frame.points, 0.02);
  FeatureWindow strict = setup.Window(grid);
  strict.max_distance = 1.0f;
  const std::vector<uint8_t> black(128, 0);
  EXPECT_FALSE(FindFeature(strict, frame.points[7], black.data()));
  const Eigen::Vector2d far = frame.points[7] + Eigen::Vector2d(5.0, 5.0);
  EXPECT_FALSE(FindFeature(setup.Window(grid), far, setup.reader.Row({5, 7}, 128)));
}

TEST(DescriptorReader, KnowsNothingOfOtherFramesAndLengths) {
  WindowSetup setup;
  EXPECT_EQ(setup.reader.Of(99), nullptr);
  EXPECT_EQ(setup.reader.Row({5, 7}, 64), nullptr);
}

}  // namespace
}  // namespace rovio_sfm
