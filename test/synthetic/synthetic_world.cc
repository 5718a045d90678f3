#include "synthetic/synthetic_world.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rovio_sfm {
namespace {

constexpr double kMinDepth = 0.2;  // map units

template <typename T>
void Shuffle(std::vector<T>* values, Rng& rng) {
  for (size_t i = values->size(); i > 1; --i) {
    std::swap((*values)[i - 1], (*values)[rng.UniformInt(static_cast<uint32_t>(i))]);
  }
}

Eigen::Vector3d MakePoint(const SyntheticOptions& options, Rng& rng) {
  const double x = rng.Uniform(-0.7, 0.7), y = rng.Uniform(-0.5, 0.5);
  if (options.scene == SyntheticScene::kPlane) {
    return options.depth * Eigen::Vector3d(x, y, 1.0 + 0.4 * x - 0.2 * y);
  }
  const double z = options.depth * rng.Uniform(0.5, 1.8);
  return {x * z, y * z, z};
}

Eigen::Vector3d CameraCenter(const SyntheticOptions& options, int cam) {
  switch (options.motion) {
    case SyntheticMotion::kSideways:
      return cam * options.step * Eigen::Vector3d(1.0, 0.02, 0.1).normalized();
    case SyntheticMotion::kForward:
      return cam * options.step * Eigen::Vector3d(0.05, 0.02, 1.0).normalized();
    case SyntheticMotion::kCircle: {
      const double angle_rad = cam * options.step / options.depth;
      return options.depth * Eigen::Vector3d(std::sin(angle_rad), 0.0, 1.0 - std::cos(angle_rad));
    }
    case SyntheticMotion::kRotation:
      break;
  }
  return Eigen::Vector3d::Zero();
}

Rigid3 MakeCamPose(const SyntheticOptions& options, int cam) {
  const double yaw_rad = options.motion == SyntheticMotion::kCircle
                             ? cam * options.step / options.depth
                             : cam * options.turn_rad;
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitY()));
  return {rotation, rotation * -CameraCenter(options, cam)};
}

bool IsInImage(const Camera& camera, const Eigen::Vector2d& x_px) {
  return x_px.x() >= 0.0 && x_px.y() >= 0.0 && x_px.x() <= camera.width - 1.0 &&
         x_px.y() <= camera.height - 1.0;
}

std::vector<SyntheticView> SeePoints(const SyntheticWorld& world, const Rigid3& cam_from_map,
                                     double noise_px, Rng& rng) {
  const double noise = noise_px / world.camera.MeanFocal();
  std::vector<SyntheticView> views;
  for (uint32_t i = 0; i < world.points.size(); ++i) {
    const Eigen::Vector3d x_in_cam = cam_from_map * world.points[i];
    const Eigen::Vector2d error = noise * Eigen::Vector2d(rng.Gaussian(), rng.Gaussian());
    if (x_in_cam.z() < kMinDepth) continue;
    const Eigen::Vector2d x = x_in_cam.hnormalized() + error;
    if (x.norm() > 1.5) continue;  // past the range where the distortion can be inverted
    const Eigen::Vector2d x_px = PixelFromNormalized(world.camera, x);
    if (IsInImage(world.camera, x_px)) views.push_back({i, x, x_px});
  }
  Shuffle(&views, rng);
  return views;
}

}  // namespace

Camera MakeSyntheticCamera() {
  Camera camera;
  camera.fx = 620.0;
  camera.fy = 621.0;
  camera.cx = 321.0;
  camera.cy = 238.0;
  camera.k1 = 0.0218;
  camera.k2 = -0.1098;
  camera.width = 640;
  camera.height = 480;
  return camera;
}

SyntheticWorld MakeSyntheticWorld(const SyntheticOptions& options) {
  Rng rng(options.seed);
  SyntheticWorld world;
  world.camera = MakeSyntheticCamera();
  for (int i = 0; i < options.num_points; ++i) world.points.push_back(MakePoint(options, rng));
  for (int cam = 0; cam < options.num_cams; ++cam) {
    world.cams_from_map.push_back(MakeCamPose(options, cam));
    world.views.push_back(SeePoints(world, world.cams_from_map.back(), options.noise_px, rng));
  }
  return world;
}

std::vector<Eigen::Vector2d> NormalizedPoints(const SyntheticWorld& world, size_t cam) {
  std::vector<Eigen::Vector2d> points;
  for (const SyntheticView& view : world.views[cam]) points.push_back(view.x_normalized);
  return points;
}

std::vector<FeatureMatch> TrueMatches(const SyntheticWorld& world, size_t cam_a, size_t cam_b) {
  std::map<uint32_t, uint32_t> feature_in_b;
  for (uint32_t b = 0; b < world.views[cam_b].size(); ++b) {
    feature_in_b[world.views[cam_b][b].point] = b;
  }
  std::vector<FeatureMatch> matches;
  for (uint32_t a = 0; a < world.views[cam_a].size(); ++a) {
    const auto it = feature_in_b.find(world.views[cam_a][a].point);
    if (it != feature_in_b.end()) matches.push_back({a, it->second, 100.0f, 0.5f});
  }
  return matches;
}

std::vector<FeatureMatch> MatchesWithOutliers(const SyntheticWorld& world, size_t cam_a,
                                              size_t cam_b, double outlier_share, Rng& rng) {
  std::vector<FeatureMatch> matches = TrueMatches(world, cam_a, cam_b);
  if (matches.empty()) return matches;
  for (FeatureMatch& match : matches) match.ratio = static_cast<float>(rng.Uniform(0.4, 0.8));
  const double num_true = static_cast<double>(matches.size());
  const int num_false = static_cast<int>(num_true * outlier_share / (1.0 - outlier_share));
  for (int i = 0; i < num_false; ++i) {
    const uint32_t a = rng.UniformInt(static_cast<uint32_t>(world.views[cam_a].size()));
    const uint32_t b = rng.UniformInt(static_cast<uint32_t>(world.views[cam_b].size()));
    if (world.views[cam_a][a].point == world.views[cam_b][b].point) continue;
    matches.push_back({a, b, 200.0f, static_cast<float>(rng.Uniform(0.6, 0.9))});
  }
  Shuffle(&matches, rng);
  return matches;
}

bool IsTrueMatch(const SyntheticWorld& world, size_t cam_a, size_t cam_b,
                 const FeatureMatch& match) {
  return world.views[cam_a][match.a].point == world.views[cam_b][match.b].point;
}

FrameFeatures MakeFeatures(const SyntheticWorld& world, size_t cam) {
  FrameFeatures features;
  for (const SyntheticView& view : world.views[cam]) {
    Keypoint keypoint;
    keypoint.x_px = static_cast<float>(view.x_px.x());
    keypoint.y_px = static_cast<float>(view.x_px.y());
    keypoint.size_px = 4.0f;
    keypoint.response = 1.0f;
    keypoint.x_normalized = view.x_normalized;
    features.keypoints.push_back(keypoint);
    features.colors.push_back({128, 128, 128});
  }
  return features;
}

SyntheticWorld TransformWorld(const Sim3& b_from_a, const SyntheticWorld& world_in_a) {
  SyntheticWorld world = world_in_a;
  for (Eigen::Vector3d& point : world.points) point = b_from_a * point;
  for (Rigid3& cam : world.cams_from_map) cam = TransformCamera(b_from_a, cam);
  return world;
}

}  // namespace rovio_sfm
