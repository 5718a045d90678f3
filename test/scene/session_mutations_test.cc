// Random sequences of mutations against two oracles: the invariants between frames, tracks and
// landmarks, and a snapshot built anew.

#include <gtest/gtest.h>

#include "scene/random_session.h"

namespace rovio_sfm {
namespace {

void ExpectSame(const FrameSnapshot& a, const FrameSnapshot& b) {
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.weak, b.weak);
  EXPECT_EQ(a.num_observations, b.num_observations);
  EXPECT_EQ(a.cam_from_session.translation, b.cam_from_session.translation);
  EXPECT_EQ(a.cam_from_session.rotation.coeffs(), b.cam_from_session.rotation.coeffs());
}

void ExpectSame(const LandmarkSnapshot& a, const LandmarkSnapshot& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.num_views, b.num_views);
  EXPECT_EQ(a.max_parallax_rad, b.max_parallax_rad);
  EXPECT_EQ(a.squared_error_normalized, b.squared_error_normalized);
}

template <typename Blocks>
void ExpectSameBlocks(const Blocks& a, const Blocks& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i]->size(), b[i]->size());
    for (size_t j = 0; j < a[i]->size(); ++j) ExpectSame((*a[i])[j], (*b[i])[j]);
  }
}

void ExpectFreshSnapshot(const Session& session) {
  const SessionSnapshot snapshot = session.Snapshot();
  FrameBlocks no_frames;
  LandmarkBlocks no_landmarks;
  ExpectSameBlocks(snapshot.frames,
                   UpdateFrameBlocks(session.keyframes(), session.light_frames(), &no_frames));
  ExpectSameBlocks(snapshot.landmarks, UpdateLandmarkBlocks(session.camera(), session.keyframes(),
                                                            session.landmarks(), &no_landmarks));
}

TEST(SessionMutations, KeepTheInvariantsAndTheSnapshotsFresh) {
  size_t most_landmarks = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    Rng rng(seed);
    Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
    for (int step = 0; step < 300; ++step) {
      MutateAtRandom(&session, rng);
      ASSERT_EQ(CheckInvariants(session), "") << "seed " << seed << ", step " << step;
      if (step % 7 == 0) ExpectFreshSnapshot(session);
      ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", step " << step;
      most_landmarks = std::max(most_landmarks, session.landmarks().size());
    }
  }
  EXPECT_GT(most_landmarks, 5u);
}

// The oracle is a deep copy. Marks are taken, and some given back, in any order that a stack
// allows.
TEST(SessionMutations, AreTakenBackToEveryMark) {
  size_t num_restored = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
    std::vector<std::pair<uint32_t, std::string>> marks;
    for (int step = 0; step < 400; ++step) {
      MutateAtRandom(&session, rng);
      if (rng.UniformInt(20) == 0) {
        const std::string content = ContentOf(session);
        marks.emplace_back(session.Mark(), content);
      }
      if (marks.empty() || rng.UniformInt(40) != 0) continue;
      const size_t chosen = rng.UniformInt(static_cast<uint32_t>(marks.size()));
      const uint64_t revision = session.revision();
      session.RestoreTo(marks[chosen].first);
      ASSERT_EQ(ContentOf(session), marks[chosen].second) << "seed " << seed << ", step " << step;
      ASSERT_EQ(CheckInvariants(session), "");
      ASSERT_GT(session.revision(), revision);
      ExpectFreshSnapshot(session);
      marks.resize(chosen);
      ++num_restored;
    }
  }
  EXPECT_GT(num_restored, 100u);
}

TEST(SessionMutations, KeepNothingWithoutAMark) {
  Rng rng(3);
  Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
  for (int step = 0; step < 300; ++step) MutateAtRandom(&session, rng);
  EXPECT_EQ(session.NumJournalBytes(), 0u);
}

}  // namespace
}  // namespace rovio_sfm
