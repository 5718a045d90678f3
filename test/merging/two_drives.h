#pragma once

#include <algorithm>
#include <vector>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/scene/place_match.h"
#include "synthetic/synthetic_drive.h"

namespace rovio_sfm {

// Two drives through one synthetic world: the even cameras of a circle and the odd ones. Frame i of
// drive a is camera 2i of the world, frame i of drive b camera 2i + 1.
struct TwoDrives {
  SyntheticWorld world;
  std::vector<FrameEvent> a, b;
};

inline uint32_t CameraOf(bool of_b, uint32_t frame) { return 2 * frame + (of_b ? 1 : 0); }

inline SyntheticDriveOptions TwoDrivesOptions(double noise_px = 0.0) {
  SyntheticDriveOptions options;
  options.world.num_cams = 32;
  options.world.step = 0.15;
  options.world.num_points = 400;
  options.world.noise_px = noise_px;
  return options;
}

inline TwoDrives MakeTwoDrives(const SyntheticDriveOptions& options = TwoDrivesOptions()) {
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  TwoDrives two{drive.world, {}, {}};
  for (uint32_t cam = 0; cam < drive.events.size(); ++cam) {
    const bool of_b = cam % 2 == 1;
    FrameEvent event = drive.events[cam];
    event.id.index = cam / 2;
    event.pairs.clear();
    if (of_b) event.id.drive.robot = "second";
    if (cam >= 2) {
      PairMatches pair;
      pair.other_index = event.id.index - 1;
      pair.verdict = PairVerdict::kGeneral;
      pair.cam_from_other =
          two.world.cams_from_map[cam] * Inverse(two.world.cams_from_map[cam - 2]);
      pair.cam_from_other.translation.normalize();
      pair.inliers = TrueMatches(two.world, cam - 2, cam);
      event.pairs.push_back(pair);
    }
    (of_b ? two.b : two.a).push_back(event);
  }
  return two;
}

// What perfect place recognition says of frame b of the second drive and frame a of the first.
inline PlaceMatch TrueOverlap(const TwoDrives& two, uint32_t a, uint32_t b) {
  PlaceMatch match;
  match.query = two.b[b].id;
  match.probability = 1.0;
  OverlapPair pair;
  pair.other = two.a[a].id;
  pair.verdict = PairVerdict::kGeneral;
  pair.inliers = TrueMatches(two.world, CameraOf(false, a), CameraOf(true, b));
  match.pairs.push_back(pair);
  return match;
}

inline MemoryFrameStore StoreOf(const TwoDrives& two) {
  MemoryFrameStore store;
  for (const FrameEvent& event : two.a) store.Put(event.id, event.features);
  for (const FrameEvent& event : two.b) store.Put(event.id, event.features);
  return store;
}

// One of the drives mapped without error, in a gauge of its own.
inline Session MappedSession(const TwoDrives& two, bool of_b, const Sim3& session_from_world) {
  const std::vector<FrameEvent>& events = of_b ? two.b : two.a;
  Session session({of_b ? 2u : 1u}, events[0].id.drive, two.world.camera);
  for (const FrameEvent& event : events) {
    const Rigid3& pose = two.world.cams_from_map[CameraOf(of_b, event.id.index)];
    session.AddKeyframe(event.id.index,
                        MakeKeyframe(event, TransformCamera(session_from_world, pose), {}));
  }
  for (const auto& [id, track] : session.tracks()) {
    if (track.members.size() < 2) continue;
    const Observation& view = track.members[0];
    const uint32_t point = two.world.views[CameraOf(of_b, view.frame)][view.feature].point;
    session.AddLandmark(id, session_from_world * two.world.points[point], {}, track.members);
  }
  return session;
}

// The links that a place match means.
inline std::vector<FeatureLink> LinksOf(const PlaceMatch& match, SessionId a, SessionId b) {
  std::vector<FeatureLink> links;
  for (const OverlapPair& pair : match.pairs) {
    for (const FeatureMatch& inlier : pair.inliers) {
      links.push_back({{a, pair.other.index, inlier.a}, {b, match.query.index, inlier.b}});
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

// Another gauge: turned, moved, and of another scale.
inline Sim3 OtherGauge() {
  return {1.7,
          Eigen::Quaterniond(Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.2, 1.0, -0.3).normalized())),
          {0.5, -1.0, 2.0}};
}

}  // namespace rovio_sfm
