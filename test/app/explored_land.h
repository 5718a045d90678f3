#pragma once

#include <map>
#include <utility>
#include <vector>

#include "merging/two_drives.h"

namespace rovio_sfm {

// Points of a world, metres. Points of one look have one descriptor: identical things.
struct Land {
  std::vector<Eigen::Vector3d> points;
  std::vector<uint32_t> looks;

  void Add(const Eigen::Vector3d& point, uint32_t look) {
    points.push_back(point);
    looks.push_back(look);
  }
};

// Points all over the room that nothing else looks like.
inline void AddClutter(uint64_t seed, uint32_t count, Land* land, double width = 2.4) {
  Rng rng(seed);
  for (uint32_t i = 0; i < count; ++i) {
    const double z = rng.Uniform(1.5, 6.0);
    land->Add({rng.Uniform(-0.6 * z, width + 0.6 * z), rng.Uniform(-0.45 * z, 0.45 * z), z},
              1'000'000 * static_cast<uint32_t>(seed) + i);
  }
}

// A textured thing: the same points, of the looks from first_look, wherever it is put.
inline void AddThing(uint32_t first_look, uint32_t count, const Eigen::Vector3d& size,
                     const Sim3& world_from_thing, Land* land) {
  Rng rng(first_look);
  for (uint32_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x(rng.Uniform(-0.5, 0.5), rng.Uniform(-0.5, 0.5), rng.Uniform(-0.5, 0.5));
    land->Add(world_from_thing * x.cwiseProduct(size), first_look + i);
  }
}

inline Sim3 PutAt(double x, double y, double z, double yaw_rad = 0.0) {
  return {1.0, Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitY())), {x, y, z}};
}

// A drive sideways past a land, mapped without error: frame i stands at x = 0.12 i and looks along
// z. Feature f of frame i shows point views[i][f].
struct Explored {
  std::vector<FrameEvent> events;
  std::vector<std::vector<uint32_t>> views;
  Land land;
  Session session;
};

inline std::shared_ptr<const FrameFeatures> FeaturesOf(const Land& land, const Rigid3& cam_from_map,
                                                       const Camera& camera,
                                                       std::vector<uint32_t>* view) {
  auto features = std::make_shared<FrameFeatures>();
  features->descriptors = {DescriptorType::kSift, DescriptorMetric::kL2, 128, {}};
  for (uint32_t i = 0; i < land.points.size(); ++i) {
    const Eigen::Vector3d x_in_cam = cam_from_map * land.points[i];
    if (x_in_cam.z() < 0.3 || x_in_cam.hnormalized().norm() > 1.0) continue;
    const Eigen::Vector2d x_px = PixelFromNormalized(camera, x_in_cam.hnormalized());
    if (x_px.minCoeff() < 0.0 || x_px.x() > 639.0 || x_px.y() > 479.0) continue;
    Keypoint keypoint;
    keypoint.x_px = static_cast<float>(x_px.x());
    keypoint.y_px = static_cast<float>(x_px.y());
    keypoint.size_px = 4.0f;
    keypoint.x_normalized = x_in_cam.hnormalized();
    features->keypoints.push_back(keypoint);
    features->colors.push_back({128, 128, 128});
    Rng rng(land.looks[i] + 77);
    for (int k = 0; k < 128; ++k) {
      features->descriptors.data.push_back(static_cast<uint8_t>(rng.UniformInt(80)));
    }
    view->push_back(i);
  }
  return features;
}

inline Explored ExploreFrom(uint32_t id, const Land& land, const Sim3& session_from_world,
                            const std::vector<Rigid3>& cams_from_world) {
  const Camera camera = MakeSyntheticCamera();
  const DriveId drive{"robot_" + std::to_string(id), 1000, id};
  Explored explored{{}, {}, land, Session({id}, drive, camera)};
  for (uint32_t i = 0; i < cams_from_world.size(); ++i) {
    const Rigid3& cam_from_world = cams_from_world[i];
    explored.views.emplace_back();
    FrameEvent event;
    event.id = {drive, i};
    event.stamp_ns = 1000 + i * 100'000'000LL;
    event.camera = camera;
    event.features = FeaturesOf(land, cam_from_world, camera, &explored.views.back());
    for (const uint32_t point : explored.views.back()) event.tracks.push_back(point + 1);
    explored.session.AddKeyframe(
        i, MakeKeyframe(event, TransformCamera(session_from_world, cam_from_world), {}));
    explored.events.push_back(std::move(event));
  }
  for (const auto& [track, members] : explored.session.tracks()) {
    if (members.members.size() < 2) continue;
    explored.session.AddLandmark(track, session_from_world * land.points[track - 1], {},
                                 members.members);
  }
  explored.session.set_state(SessionState::kFinished);
  return explored;
}

inline Explored Explore(uint32_t id, const Land& land, const Sim3& session_from_world,
                        uint32_t num_frames = 20) {
  std::vector<Rigid3> cams_from_world;
  for (uint32_t i = 0; i < num_frames; ++i) {
    cams_from_world.push_back({Eigen::Quaterniond::Identity(), {-0.12 * i, 0.0, 0.0}});
  }
  return ExploreFrom(id, land, session_from_world, cams_from_world);
}

// Cameras on a circle round the origin that look at it, by their angle about the vertical.
inline std::vector<Rigid3> RoundTheOrigin(double radius, const std::vector<double>& angles_deg) {
  std::vector<Rigid3> cams_from_world;
  for (const double angle_deg : angles_deg) {
    const Eigen::AngleAxisd turn(angle_deg * M_PI / 180.0, Eigen::Vector3d::UnitY());
    cams_from_world.push_back({Eigen::Quaterniond(turn), {0.0, 0.0, radius}});
  }
  return cams_from_world;
}

// What recognition says that goes by looks alone: a frame of b (the query) against one of a,
// matched where both show one of the looks [first, last).
inline PlaceMatch MatchLooks(const Explored& a, uint32_t frame_a, const Explored& b,
                             uint32_t frame_b, uint32_t first = 0, uint32_t last = UINT32_MAX) {
  std::map<uint32_t, uint32_t> feature_of_a;  // by look
  for (uint32_t f = 0; f < a.views[frame_a].size(); ++f) {
    feature_of_a[a.land.looks[a.views[frame_a][f]]] = f;
  }
  PlaceMatch match;
  match.query = b.events[frame_b].id;
  match.probability = 1.0;
  OverlapPair pair;
  pair.other = a.events[frame_a].id;
  pair.verdict = PairVerdict::kGeneral;
  for (uint32_t f = 0; f < b.views[frame_b].size(); ++f) {
    const uint32_t look = b.land.looks[b.views[frame_b][f]];
    const auto found = feature_of_a.find(look);
    if (look < first || look >= last || found == feature_of_a.end()) continue;
    pair.inliers.push_back({found->second, f, 100.0f, 0.5f});
  }
  match.pairs.push_back(std::move(pair));
  return match;
}

}  // namespace rovio_sfm
