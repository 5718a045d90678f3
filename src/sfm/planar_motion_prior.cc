#include "rovio_sfm/sfm/planar_motion_prior.h"

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>

#include <Eigen/Dense>

#include "rovio_sfm/sfm/planar_motion_cost.h"

namespace rovio_sfm {
namespace {

constexpr double kLeastAgreement = 0.5;  // length of the mean of the up directions

// A camera with the pose block it has in the problem.
struct MountedCamera {
  const BundleCamera* camera = nullptr;
  double* pose = nullptr;

  Eigen::Quaterniond BaseFromCam() const { return camera->base_from_camera->rotation; }

  // Of the base's origin, map units; without a scale the base is taken to be in the camera.
  Eigen::Vector3d BaseInCam(const PlanarMotion& planar) const {
    if (!planar.metres_per_unit) return Eigen::Vector3d::Zero();
    return OriginInA(*camera->base_from_camera) / *planar.metres_per_unit;
  }
};

std::vector<MountedCamera> FindMounted(const std::vector<BundleCamera>& cameras,
                                       std::vector<PoseBlock>* poses,
                                       const ceres::Problem& problem) {
  std::vector<MountedCamera> mounted;
  for (size_t i = 0; i < cameras.size(); ++i) {
    double* pose = (*poses)[i].data();
    const bool is_observed = problem.HasParameterBlock(pose);
    if (cameras[i].base_from_camera && is_observed) mounted.push_back({&cameras[i], pose});
  }
  return mounted;
}

// The mean of the bases. False where their up directions contradict each other.
bool FitFloor(const std::vector<MountedCamera>& mounted, const PlanarMotion& planar,
              FloorBlocks* floor) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();
  const double count = static_cast<double>(mounted.size());
  for (const MountedCamera& one : mounted) {
    const Rigid3 map_from_cam = Inverse(one.camera->cam_from_map);
    const Eigen::Vector3d up_in_cam = one.BaseFromCam().conjugate() * Eigen::Vector3d::UnitZ();
    up += map_from_cam.rotation * up_in_cam / count;
    middle += map_from_cam * one.BaseInCam(planar) / count;
  }
  if (!(up.norm() > kLeastAgreement)) return false;
  Eigen::Map<Eigen::Vector3d>{floor->normal.data()} = up.normalized();
  floor->offset = up.normalized().dot(middle);
  return true;
}

// A constant error of the extrinsics is seen as a tilt that turns with the robot: no plane absorbs
// it once the robot turns, and without a block of its own it would bend the map. Where the robot
// goes straight, tilt and normal are one and only the prior tells them apart; there neither
// matters, for the map's own roll is free with them. To the heights such an error adds a constant,
// which is the offset's.
void AddMountTilt(const PlanarMotion& planar, FloorBlocks* floor, ceres::Problem* problem) {
  const Eigen::Matrix2d weight = Eigen::Matrix2d::Identity() / planar.mount_sigma_rad;
  problem->AddResidualBlock(new ceres::NormalPrior(weight, Eigen::Vector2d::Zero()), nullptr,
                            floor->mount_tilt.data());
}

}  // namespace

void AddPlanarMotion(const std::vector<BundleCamera>& cameras, const PlanarMotion& planar,
                     std::vector<PoseBlock>* poses, FloorBlocks* floor, ceres::Problem* problem) {
  const std::vector<MountedCamera> mounted = FindMounted(cameras, poses, *problem);
  if (!FitFloor(mounted, planar, floor)) return;
  auto* tilt_loss = new ceres::CauchyLoss(planar.loss_sigmas);  // each owned by the problem
  for (const MountedCamera& one : mounted) {
    problem->AddResidualBlock(MakeTiltCost(one.BaseFromCam(), planar.tilt_sigma_rad), tilt_loss,
                              one.pose, floor->normal.data(), floor->mount_tilt.data());
  }
  AddMountTilt(planar, floor, problem);
  problem->SetManifold(floor->normal.data(), new ceres::SphereManifold<3>);
  if (!planar.metres_per_unit) return;
  auto* height_loss = new ceres::CauchyLoss(planar.loss_sigmas);
  const double sigma = planar.height_sigma_m / *planar.metres_per_unit;
  for (const MountedCamera& one : mounted) {
    problem->AddResidualBlock(MakeHeightCost(one.BaseInCam(planar), sigma), height_loss, one.pose,
                              floor->normal.data(), &floor->offset);
  }
}

}  // namespace rovio_sfm
