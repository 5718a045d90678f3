#include "rovio_sfm/sfm/prune_landmarks.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

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

// Takes observations of `frames` away until num_kept landmarks are seen there and elsewhere.
void Cut(const std::set<uint32_t>& frames, size_t num_kept, Session* session) {
  std::vector<TrackId> across;
  const auto& landmarks = session->landmarks();
  for (const auto& [id, landmark] : landmarks) {
    size_t num_inside = 0;
    for (const Observation& view : landmark.observations) num_inside += frames.count(view.frame);
    if (num_inside > 0 && num_inside < landmark.observations.size()) across.push_back(id);
  }
  ASSERT_GE(across.size(), num_kept);
  across.erase(across.begin(), across.begin() + static_cast<std::ptrdiff_t>(num_kept));
  for (const TrackId id : across) {
    const std::vector<Observation> views = landmarks.at(id).observations;
    for (const Observation& view : views) {
      if (frames.count(view.frame) == 1 && landmarks.count(id) == 1) {
        session->RemoveObservation(id, view);
      }
    }
  }
}

TEST(PruneLandmarks, RemovesTheKeyframeThatNineLandmarksHold) {
  Session session = MakeMappedSession(MakeWorld(0.0));
  LightFrame light;
  light.reference = 4;
  session.AddLightFrame(7, light);
  Cut({4}, 10, &session);
  EXPECT_EQ(PruneAllLandmarks(kNoParallax, &session).num_frames, 0u);
  Cut({4}, 9, &session);
  EXPECT_EQ(PruneAllLandmarks(kNoParallax, &session).num_frames, 1u);
  EXPECT_EQ(session.keyframes().count(4), 0u);
  EXPECT_TRUE(session.light_frames().empty());
  EXPECT_EQ(CheckInvariants(session), "");
}

// Nothing says how large the one part is beside the other.
TEST(PruneLandmarks, RemovesTheSmallerOfTwoPartsThatHardlyHangTogether) {
  for (const bool newer_is_larger : {false, true}) {
    Session session = MakeMappedSession(MakeWorld(0.0));
    const std::set<uint32_t> smaller =
        newer_is_larger ? std::set<uint32_t>{0, 1} : std::set<uint32_t>{3, 4};
    Cut(smaller, 9, &session);
    EXPECT_EQ(PruneAllLandmarks(kNoParallax, &session).num_frames, 2u);
    for (const uint32_t frame : smaller) EXPECT_EQ(session.keyframes().count(frame), 0u);
    EXPECT_EQ(session.keyframes().size(), 3u);
    EXPECT_EQ(CheckInvariants(session), "");
  }
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
