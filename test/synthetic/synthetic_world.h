#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

enum class SyntheticScene { kVolume, kPlane };
enum class SyntheticMotion { kSideways, kForward, kRotation, kCircle };

struct SyntheticOptions {
  uint64_t seed = 1;
  SyntheticScene scene = SyntheticScene::kVolume;
  SyntheticMotion motion = SyntheticMotion::kSideways;
  int num_points = 500;
  int num_cams = 2;
  double step = 0.2;       // map units between neighbouring cameras (none for kRotation)
  double turn_rad = 0.03;  // yaw between neighbouring cameras
  double depth = 4.0;      // map units from the first camera to the middle of the scene
  double noise_px = 0.0;   // standard deviation per coordinate of every view
};

// A point as one camera sees it, with noise.
struct SyntheticView {
  uint32_t point = 0;  // index into SyntheticWorld::points
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();
  Eigen::Vector2d x_px = Eigen::Vector2d::Zero();  // raw pixel, with distortion
};

// Points, cameras and what the cameras see. The map frame is the first camera: x right, y down, z
// forward. views[cam][feature] are in seeded random order, only those inside the image.
struct SyntheticWorld {
  Camera camera;
  std::vector<Eigen::Vector3d> points;
  std::vector<Rigid3> cams_from_map;
  std::vector<std::vector<SyntheticView>> views;
};

// A 640x480 camera like the Rovio's, with its distortion.
Camera MakeSyntheticCamera();

SyntheticWorld MakeSyntheticWorld(const SyntheticOptions& options);

// The normalised coordinates of all features of one camera, by feature.
std::vector<Eigen::Vector2d> NormalizedPoints(const SyntheticWorld& world, size_t cam);

// The true matches of two cameras, sorted by feature a; ratio 0.5.
std::vector<FeatureMatch> TrueMatches(const SyntheticWorld& world, size_t cam_a, size_t cam_b);

// The true matches with false ones among them, in random order, so that outlier_share of all are
// false. False matches have a ratio in [0.6, 0.9), true ones in [0.4, 0.8).
std::vector<FeatureMatch> MatchesWithOutliers(const SyntheticWorld& world, size_t cam_a,
                                              size_t cam_b, double outlier_share, Rng& rng);

// True if the match joins views of one point.
bool IsTrueMatch(const SyntheticWorld& world, size_t cam_a, size_t cam_b,
                 const FeatureMatch& match);

// Keypoints of one camera as a frontend would give them: no descriptors, grey.
FrameFeatures MakeFeatures(const SyntheticWorld& world, size_t cam);

// The same world in another gauge; the views stay.
SyntheticWorld TransformWorld(const Sim3& b_from_a, const SyntheticWorld& world_in_a);

}  // namespace rovio_sfm
