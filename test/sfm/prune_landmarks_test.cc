#include "rovio_sfm/sfm/prune_landmarks.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

SyntheticWorld MakeWorld(double noise_px) {
  SyntheticOptions options;
  options.num_points = 150;
  options.num_cams = 5;
  options.noise_px = noise_px;
  return MakeSyntheticWorld(options);
}

size_t NumObservations(const Session& session) {
  size_t count = 0;
  for (const auto& [id, landmark] : session.landmarks()) count += landmark.observations.size();
  return count;
}

// A landmark with that many views.
TrackId LandmarkWithViews(const Session& session, size_t num_views) {
  for (const auto& [id, landmark] : session.landmarks()) {
    if (landmark.observations.size() == num_views) return id;
  }
  return 0;
}

constexpr LandmarkLimits kNoParallax{0.0, 4.0};

TEST(PruneLandmarks, LeavesATrueMapAlone) {
  Session session = MakeMappedSession(MakeWorld(0.0));
  const size_t before = NumObservations(session);
  const PruneReport report = PruneAllLandmarks(kNoParallax, &session);
  EXPECT_EQ(report.num_observations, 0u);
  EXPECT_EQ(report.num_landmarks, 0u);
  EXPECT_EQ(NumObservations(session), before);
}

TEST(PruneLandmarks, RemovesTheOneBadObservation) {
  const SyntheticWorld world = MakeWorld(0.0);
  Session session = MakeSyntheticSession(world);
  const TrackId id = LandmarkWithViews(MakeMappedSession(world), 5);
  ASSERT_NE(id, 0u);
  // Frame 4 sees the point 10 px off.
  Keyframe bad = MakeSyntheticKeyframe(world, 4);
  session.RemoveKeyframe(4);
  for (size_t i = 0; i < bad.tracks.size(); ++i) {
    if (bad.tracks[i] == id) bad.points[i].x() += 10.0 / world.camera.MeanFocal();
  }
  session.AddKeyframe(4, bad);
  session.AddLandmark(id, world.points[id - 1], {}, session.tracks().at(id).members);
  const PruneReport report = PruneLandmarks({id}, kNoParallax, &session);
  EXPECT_EQ(report.num_observations, 1u);
  EXPECT_EQ(report.num_landmarks, 0u);
  EXPECT_EQ(session.landmarks().at(id).observations.size(), 4u);
  EXPECT_EQ(session.tracks().at(id).members.size(), 5u);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(PruneLandmarks, RemovesALandmarkThatNoTwoViewsAgreeWith) {
  Session session = MakeMappedSession(MakeWorld(0.0));
  const TrackId id = LandmarkWithViews(session, 5);
  session.SetPosition(id, session.landmarks().at(id).position + Eigen::Vector3d(0, 1, 0));
  const PruneReport report = PruneLandmarks({id}, kNoParallax, &session);
  EXPECT_EQ(report.num_observations, 5u);
  EXPECT_EQ(report.num_landmarks, 1u);
  EXPECT_EQ(session.FindLandmark(id), nullptr);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(PruneLandmarks, RemovesLandmarksBehindTheirCamerasAndNotFiniteOnes) {
  Session session = MakeMappedSession(MakeWorld(0.0));
  const TrackId behind = session.landmarks().begin()->first;
  const TrackId unknown = std::next(session.landmarks().begin())->first;
  session.SetPosition(behind, -session.landmarks().at(behind).position);
  session.SetPosition(unknown, Eigen::Vector3d::Constant(std::nan("")));
  EXPECT_EQ(PruneAllLandmarks(kNoParallax, &session).num_landmarks, 2u);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(PruneLandmarks, RemovesLandmarksWithoutParallax) {
  Session session = MakeMappedSession(MakeWorld(0.0));
  const size_t count = session.landmarks().size();
  const PruneReport some = PruneAllLandmarks({0.1, 4.0}, &session);
  EXPECT_GT(some.num_landmarks, 0u);
  EXPECT_LT(some.num_landmarks, count);
  EXPECT_EQ(session.landmarks().size(), count - some.num_landmarks);
  EXPECT_EQ(PruneAllLandmarks({3.1, 4.0}, &session).num_landmarks, count - some.num_landmarks);
  EXPECT_TRUE(session.landmarks().empty());
}

TEST(PruneLandmarks, PassesOverTracksWithoutLandmark) {
  Session session = MakeSyntheticSession(MakeWorld(0.0));
  const PruneReport report = PruneLandmarks({1, 2, 999}, {}, &session);
  EXPECT_EQ(report.num_observations + report.num_landmarks, 0u);
}

TEST(ResidualSpread, IsTheNoiseInSigmas) {
  EXPECT_LT(ResidualSpread(MakeMappedSession(MakeWorld(0.0))), 1e-9);
  EXPECT_NEAR(ResidualSpread(MakeMappedSession(MakeWorld(1.0))), 1.0, 0.1);
  EXPECT_NEAR(ResidualSpread(MakeMappedSession(MakeWorld(2.0))), 2.0, 0.2);
  EXPECT_EQ(ResidualSpread(MakeSyntheticSession(MakeWorld(1.0))), 0.0);
}

}  // namespace
}  // namespace rovio_sfm
