#include "synthetic/synthetic_session.h"

namespace rovio_sfm {

Keyframe MakeSyntheticKeyframe(const SyntheticWorld& world, size_t cam) {
  Keyframe frame;
  frame.stamp_ns = static_cast<int64_t>(cam) * 100'000'000;
  frame.image_name = std::to_string(cam);
  frame.cam_from_session = world.cams_from_map[cam];
  for (const SyntheticView& view : world.views[cam]) {
    frame.points.push_back(view.x_normalized);
    frame.sigmas.push_back(1.0 / world.camera.MeanFocal());
    frame.colors.push_back({static_cast<uint8_t>(view.point % 256), 0, 0});
    frame.tracks.push_back(TrackOfPoint(view.point));
  }
  return frame;
}

Session MakeSyntheticSession(const SyntheticWorld& world) {
  Session session({1}, {"rovio", 1, 0}, world.camera);
  for (uint32_t cam = 0; cam < world.views.size(); ++cam) {
    session.AddKeyframe(cam, MakeSyntheticKeyframe(world, cam));
  }
  return session;
}

Session MakeMappedSession(const SyntheticWorld& world) {
  Session session = MakeSyntheticSession(world);
  for (uint32_t point = 0; point < world.points.size(); ++point) {
    const auto track = session.tracks().find(TrackOfPoint(point));
    if (track == session.tracks().end() || track->second.members.size() < 2) continue;
    session.AddLandmark(track->first, world.points[point], {}, track->second.members);
  }
  return session;
}

Rigid3 PerturbPose(const Rigid3& cam_from_map, double sigma_rad, double sigma, Rng& rng) {
  const auto step = [&rng] {
    const double x = rng.Gaussian(), y = rng.Gaussian(), z = rng.Gaussian();
    return Eigen::Vector3d(x, y, z);
  };
  const Eigen::Vector3d turn = sigma_rad * step(), shift = sigma * step();
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
  return {(rotation * cam_from_map.rotation).normalized(), cam_from_map.translation + shift};
}

double PoseDistance(const Rigid3& cam_from_map_a, const Rigid3& cam_from_map_b) {
  return RotationAngle(cam_from_map_a.rotation * cam_from_map_b.rotation.conjugate()) +
         (OriginInA(cam_from_map_a) - OriginInA(cam_from_map_b)).norm();
}

}  // namespace rovio_sfm
