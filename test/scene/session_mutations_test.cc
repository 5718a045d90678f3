// Random sequences of mutations against two oracles: the invariants between frames, tracks and
// landmarks, and a snapshot built anew.

#include <gtest/gtest.h>

#include "rovio_sfm/scene/session.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kNumTracks = 40;
constexpr uint32_t kNumFrames = 200;  // indices of several blocks

template <typename Map>
typename Map::key_type AnyKey(const Map& map, Rng& rng) {
  return std::next(map.begin(), rng.UniformInt(static_cast<uint32_t>(map.size())))->first;
}

TrackId AnyId(Rng& rng) { return 1 + rng.UniformInt(kNumTracks); }

void AddRandomKeyframe(Session* session, Rng& rng) {
  const uint32_t index = rng.UniformInt(kNumFrames);
  if (session->keyframes().count(index) + session->light_frames().count(index) != 0) return;
  Keyframe frame;
  for (int i = 0; i < 12; ++i) {
    frame.tracks.push_back(rng.UniformInt(4) == 0 ? 0 : AnyId(rng));
    frame.points.push_back({rng.Uniform(-0.5, 0.5), rng.Uniform(-0.5, 0.5)});
    frame.sigmas.push_back(0.001);
  }
  frame.colors.resize(12);
  session->AddKeyframe(index, frame);
}

void AddRandomLightFrame(Session* session, Rng& rng) {
  const uint32_t index = rng.UniformInt(kNumFrames);
  if (session->keyframes().empty() || session->keyframes().count(index) != 0) return;
  LightFrame light;
  light.reference = AnyKey(session->keyframes(), rng);
  light.cam_from_reference = PerturbPose({}, 0.1, 0.1, rng);
  session->AddLightFrame(index, light);
}

void AddRandomLandmark(Session* session, Rng& rng) {
  if (session->tracks().empty()) return;
  const TrackId id = AnyKey(session->tracks(), rng);
  const auto& members = session->tracks().at(id).members;
  if (members.size() < 2 || session->FindLandmark(id) != nullptr) return;
  session->AddLandmark(id, {rng.Gaussian(), rng.Gaussian(), 5.0}, {}, {members[0], members.back()});
}

void ToggleRandomObservation(Session* session, Rng& rng) {
  if (session->landmarks().empty()) return;
  const TrackId id = AnyKey(session->landmarks(), rng);
  const auto& members = session->tracks().at(id).members;
  const Observation member = members[rng.UniformInt(static_cast<uint32_t>(members.size()))];
  if (session->keyframe(member.frame).observed[member.feature]) {
    session->RemoveObservation(id, member);
  } else {
    session->AddObservation(id, member);
  }
}

void UniteRandomTracks(Session* session, Rng& rng) {
  const TrackId a = AnyId(rng), b = AnyId(rng);
  const bool both = session->FindLandmark(a) != nullptr && session->FindLandmark(b) != nullptr;
  const bool united = both ? session->UniteLandmarks(a, b, {0, 0, 5}) : session->UniteTracks(a, b);
  EXPECT_EQ(united, session->RootOf(a) == session->RootOf(b));
}

void MoveRandomFeature(Session* session, Rng& rng) {
  if (session->keyframes().empty() || session->tracks().empty()) return;
  const uint32_t frame = AnyKey(session->keyframes(), rng);
  const TrackId track = AnyKey(session->tracks(), rng);
  session->MoveToTrack({frame, rng.UniformInt(12)}, track);
}

void ChangeRandomKeyframe(Session* session, Rng& rng) {
  if (session->keyframes().empty()) return;
  const uint32_t frame = AnyKey(session->keyframes(), rng);
  switch (rng.UniformInt(8)) {
    case 0:
      return session->RemoveKeyframe(frame);
    case 1:
      return session->SetWeak(frame, rng.UniformInt(2) == 0);
    default:
      return session->SetPose(frame, PerturbPose({}, 0.1, 0.3, rng));
  }
}

void ChangeRandomLandmark(Session* session, Rng& rng) {
  if (session->landmarks().empty()) return;
  const TrackId id = AnyKey(session->landmarks(), rng);
  if (rng.UniformInt(4) == 0) return session->RemoveLandmark(id);
  session->SetPosition(id, {rng.Gaussian(), rng.Gaussian(), 5.0});
}

void MutateAtRandom(Session* session, Rng& rng) {
  constexpr void (*kMutations[])(Session*, Rng&) = {
      AddRandomKeyframe,       AddRandomKeyframe,   AddRandomLightFrame, AddRandomLandmark,
      AddRandomLandmark,       UniteRandomTracks,   MoveRandomFeature,   ChangeRandomKeyframe,
      ToggleRandomObservation, ChangeRandomLandmark};
  kMutations[rng.UniformInt(static_cast<uint32_t>(std::size(kMutations)))](session, rng);
}

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
  ExpectSameBlocks(snapshot.frames, UpdateFrameBlocks(session, &no_frames));
  ExpectSameBlocks(snapshot.landmarks, UpdateLandmarkBlocks(session, &no_landmarks));
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

}  // namespace
}  // namespace rovio_sfm
