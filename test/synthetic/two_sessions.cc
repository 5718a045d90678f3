#include "synthetic/two_sessions.h"

#include <cmath>

namespace rovio_sfm {
namespace {

SyntheticWorld EverySecondCamera(const SyntheticWorld& world, size_t first) {
  SyntheticWorld part{world.camera, world.points, {}, {}};
  for (size_t cam = first; cam < world.views.size(); cam += 2) {
    part.cams_from_map.push_back(world.cams_from_map[cam]);
    part.views.push_back(world.views[cam]);
  }
  return part;
}

Session MakeSession(uint32_t id, const SyntheticWorld& world, double sigma_log_distance, Rng& rng) {
  Session session({id}, {"rovio", static_cast<int64_t>(id), 0}, world.camera);
  for (uint32_t cam = 0; cam < world.views.size(); ++cam) {
    session.AddKeyframe(cam, MakeSyntheticKeyframe(world, cam));
  }
  const Eigen::Vector3d center = OriginInA(world.cams_from_map[0]);
  for (uint32_t point = 0; point < world.points.size(); ++point) {
    const auto track = session.tracks().find(TrackOfPoint(point));
    if (track == session.tracks().end() || track->second.members.size() < 2) continue;
    const double stretch = std::exp(sigma_log_distance * rng.Gaussian());
    session.AddLandmark(track->first, center + stretch * (world.points[point] - center), {},
                        track->second.members);
  }
  return session;
}

}  // namespace

SyntheticOptions TwoSessionsOptions::DefaultWorld() {
  SyntheticOptions world;
  world.num_points = 300;
  world.num_cams = 8;
  return world;
}

TwoSessions MakeTwoSessions(const TwoSessionsOptions& options) {
  const SyntheticWorld world = MakeSyntheticWorld(options.world);
  const SyntheticWorld world_a = EverySecondCamera(world, 0);
  const SyntheticWorld world_b = TransformWorld(options.b_from_a, EverySecondCamera(world, 1));
  Rng rng(options.world.seed + 1);
  const Session a = MakeSession(1, world_a, options.sigma_log_distance, rng);
  const Session b = MakeSession(2, world_b, options.sigma_log_distance, rng);
  return {world_a, world_b, options.b_from_a, a, b};
}

std::vector<FeatureMatch> CrossFeatureMatches(const TwoSessions& sessions, uint32_t keyframe_a,
                                              uint32_t keyframe_b, double outlier_share, Rng& rng) {
  SyntheticWorld pair = sessions.world_a;
  pair.views = {sessions.world_a.views[keyframe_a], sessions.world_b.views[keyframe_b]};
  return MatchesWithOutliers(pair, 0, 1, outlier_share, rng);
}

double SimilarityDistance(const Sim3& b_from_a, const Sim3& other_b_from_a,
                          const Eigen::Vector3d& x_in_a) {
  return RotationAngle(b_from_a.rotation * other_b_from_a.rotation.conjugate()) +
         std::abs(std::log(b_from_a.scale / other_b_from_a.scale)) +
         (b_from_a * x_in_a - other_b_from_a * x_in_a).norm() / other_b_from_a.scale;
}

}  // namespace rovio_sfm
