#pragma once

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>

#include "rovio_sfm/scene/session.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {

// Random changes of a session, for tests that know what must hold after any of them.

constexpr uint32_t kNumTracks = 40;
constexpr uint32_t kNumFrames = 200;  // indices of several blocks
constexpr uint32_t kNumFeatures = 12;

// What a frame brings itself, at whole pixels; poses and tracks come at random.
inline Keyframe BareKeyframe(uint32_t index) {
  Rng rng(index);
  Keyframe frame;
  frame.stamp_ns = index;
  for (uint32_t i = 0; i < kNumFeatures; ++i) {
    const double x_px = 1 + rng.UniformInt(638), y_px = 1 + rng.UniformInt(478);
    frame.points.push_back(*NormalizedFromPixel(MakeSyntheticCamera(), {x_px, y_px}));
  }
  frame.sigmas.assign(kNumFeatures, 0.001);
  frame.colors.resize(kNumFeatures);
  frame.tracks.resize(kNumFeatures);
  return frame;
}

inline LightFrame BareLightFrame(uint32_t index) {
  LightFrame frame;
  frame.stamp_ns = index;
  return frame;
}

template <typename Map>
typename Map::key_type AnyKey(const Map& map, Rng& rng) {
  return std::next(map.begin(), rng.UniformInt(static_cast<uint32_t>(map.size())))->first;
}

inline TrackId AnyId(Rng& rng) { return 1 + rng.UniformInt(kNumTracks); }

inline void AddRandomKeyframe(Session* session, Rng& rng) {
  const uint32_t index = rng.UniformInt(kNumFrames);
  if (session->keyframes().count(index) + session->light_frames().count(index) != 0) return;
  Keyframe frame = BareKeyframe(index);
  for (TrackId& track : frame.tracks) track = rng.UniformInt(4) == 0 ? 0 : AnyId(rng);
  frame.cam_from_session = PerturbPose({}, 0.1, 0.3, rng);
  session->AddKeyframe(index, frame);
}

inline void AddRandomLightFrame(Session* session, Rng& rng) {
  const uint32_t index = rng.UniformInt(kNumFrames);
  if (session->keyframes().empty() || session->keyframes().count(index) != 0) return;
  LightFrame light = BareLightFrame(index);
  light.reference = AnyKey(session->keyframes(), rng);
  light.cam_from_reference = PerturbPose({}, 0.1, 0.1, rng);
  session->AddLightFrame(index, light);
}

inline void ChangeRandomLightFrame(Session* session, Rng& rng) {
  if (session->light_frames().empty()) return;
  session->SetLightPose(AnyKey(session->light_frames(), rng), AnyKey(session->keyframes(), rng),
                        PerturbPose({}, 0.1, 0.1, rng), rng.UniformInt(50));
}

inline void AddRandomLandmark(Session* session, Rng& rng) {
  if (session->tracks().empty()) return;
  const TrackId id = AnyKey(session->tracks(), rng);
  const auto& members = session->tracks().at(id).members;
  if (members.size() < 2 || session->FindLandmark(id) != nullptr) return;
  session->AddLandmark(id, {rng.Gaussian(), rng.Gaussian(), 5.0}, {}, {members[0], members.back()});
}

inline void ToggleRandomObservation(Session* session, Rng& rng) {
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

inline void UniteRandomTracks(Session* session, Rng& rng) {
  const TrackId a = AnyId(rng), b = AnyId(rng);
  const bool both = session->FindLandmark(a) != nullptr && session->FindLandmark(b) != nullptr;
  const bool united = both ? session->UniteLandmarks(a, b, {0, 0, 5}) : session->UniteTracks(a, b);
  EXPECT_EQ(united, session->RootOf(a) == session->RootOf(b));
}

inline void MoveRandomFeature(Session* session, Rng& rng) {
  if (session->keyframes().empty() || session->tracks().empty()) return;
  const uint32_t frame = AnyKey(session->keyframes(), rng);
  const TrackId track = AnyKey(session->tracks(), rng);
  session->MoveToTrack({frame, rng.UniformInt(kNumFeatures)}, track);
}

inline void ChangeRandomKeyframe(Session* session, Rng& rng) {
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

inline void ChangeRandomLandmark(Session* session, Rng& rng) {
  if (session->landmarks().empty()) return;
  const TrackId id = AnyKey(session->landmarks(), rng);
  if (rng.UniformInt(4) == 0) return session->RemoveLandmark(id);
  session->SetPosition(id, {rng.Gaussian(), rng.Gaussian(), 5.0});
}

inline void MutateAtRandom(Session* session, Rng& rng) {
  constexpr void (*kMutations[])(Session*, Rng&) = {
      AddRandomKeyframe,       AddRandomKeyframe,    AddRandomLightFrame,   AddRandomLandmark,
      AddRandomLandmark,       UniteRandomTracks,    MoveRandomFeature,     ChangeRandomKeyframe,
      ToggleRandomObservation, ChangeRandomLandmark, ChangeRandomLightFrame};
  kMutations[rng.UniformInt(static_cast<uint32_t>(std::size(kMutations)))](session, rng);
}

// Everything of a session that the journal gives back, as text.
inline std::string ContentOf(const Session& session) {
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

}  // namespace rovio_sfm
