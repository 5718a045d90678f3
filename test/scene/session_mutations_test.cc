// Random sequences of mutations against two oracles: the invariants between frames, tracks and
// landmarks, and a snapshot built anew.

#include <gtest/gtest.h>

#include <sstream>

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

void ChangeRandomLightFrame(Session* session, Rng& rng) {
  if (session->light_frames().empty()) return;
  session->SetLightPose(AnyKey(session->light_frames(), rng), AnyKey(session->keyframes(), rng),
                        PerturbPose({}, 0.1, 0.1, rng), rng.UniformInt(50));
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
      AddRandomKeyframe,       AddRandomKeyframe,    AddRandomLightFrame,   AddRandomLandmark,
      AddRandomLandmark,       UniteRandomTracks,    MoveRandomFeature,     ChangeRandomKeyframe,
      ToggleRandomObservation, ChangeRandomLandmark, ChangeRandomLightFrame};
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

// Everything of a session that the journal gives back, as text.
std::string ContentOf(const Session& session) {
  std::ostringstream out;
  out.precision(17);
  const auto write_pose = [&](const Rigid3& pose) {
    out << pose.rotation.coeffs().transpose() << " " << pose.translation.transpose() << "\n";
  };
  const auto write_all = [&](const std::vector<Observation>& observations) {
    for (const Observation& o : observations) out << " " << o.frame << "." << o.feature;
    out << "\n";
  };
  for (const auto& [index, frame] : session.keyframes()) {
    out << "keyframe " << index << " " << frame.weak << " " << frame.num_observed << " ";
    for (const TrackId track : frame.tracks) out << track << " ";
    for (const uint8_t observed : frame.observed) out << int{observed};
    write_pose(frame.cam_from_session);
  }
  for (const auto& [index, frame] : session.light_frames()) {
    out << "light " << index << " " << frame.reference << " " << frame.num_inliers << " ";
    write_pose(frame.cam_from_reference);
  }
  for (const auto& [id, track] : session.tracks()) {
    out << "track " << id;
    write_all(track.members);
  }
  for (const auto& [id, landmark] : session.landmarks()) {
    out << "landmark " << id << " " << landmark.position.transpose();
    write_all(landmark.observations);
  }
  for (TrackId id = 1; id <= kNumTracks; ++id) out << session.RootOf(id) << " ";
  if (session.scale()) out << session.scale()->metres_per_unit;
  return out.str();
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
