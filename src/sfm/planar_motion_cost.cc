#include "rovio_sfm/sfm/planar_motion_cost.h"

#include <ceres/sized_cost_function.h>

namespace rovio_sfm {
namespace {

using RowMajor2x7 = Eigen::Matrix<double, 2, kPoseSize, Eigen::RowMajor>;
using RowMajor2x3 = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using RowMajor2x2 = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;
using Row7 = Eigen::Matrix<double, 1, kPoseSize>;
using ConstVector3 = Eigen::Map<const Eigen::Vector3d>;

class TiltCost final : public ceres::SizedCostFunction<2, kPoseSize, 3, 2> {
 public:
  TiltCost(const Eigen::Quaterniond& base_from_cam, double sigma_rad)
      : axes_(base_from_cam.toRotationMatrix().topRows<2>() / sigma_rad),
        weight_(1.0 / sigma_rad) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Quaterniond> rotation(parameters[0]);
    const Eigen::Map<const Eigen::Vector2d> tilt(parameters[2]);
    const Eigen::Vector3d normal_in_cam = rotation * ConstVector3(parameters[1]);
    Eigen::Map<Eigen::Vector2d>{residuals} = axes_ * normal_in_cam - weight_ * tilt;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMajor2x7> by_pose(jacobians[0]);
      by_pose.setZero();
      for (int i = 0; i < 2; ++i) {
        by_pose.row(i).head<3>() = normal_in_cam.cross(axes_.row(i).transpose());
      }
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<RowMajor2x3>{jacobians[1]} = axes_ * rotation.toRotationMatrix();
    }
    if (jacobians[2] != nullptr) {
      Eigen::Map<RowMajor2x2>{jacobians[2]} = -weight_ * Eigen::Matrix2d::Identity();
    }
    return true;
  }

 private:
  RowMajor2x3 axes_;  // the base's x and y in the camera, in sigmas
  double weight_;
};

class HeightCost final : public ceres::SizedCostFunction<1, kPoseSize, 3, 1> {
 public:
  HeightCost(const Eigen::Vector3d& x_in_cam, double sigma)
      : x_in_cam_(x_in_cam), weight_(1.0 / sigma) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Quaterniond> rotation(parameters[0]);
    const Eigen::Vector3d rotated = x_in_cam_ - ConstVector3(parameters[0] + 4);
    const Eigen::Vector3d normal_in_cam = rotation * ConstVector3(parameters[1]);
    residuals[0] = weight_ * (normal_in_cam.dot(rotated) - parameters[2][0]);
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      Eigen::Map<Row7> by_pose(jacobians[0]);
      by_pose.head<3>() = weight_ * normal_in_cam.cross(rotated);
      by_pose.segment<3>(3) = -weight_ * normal_in_cam;
      by_pose[6] = 0.0;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Eigen::RowVector3d>{jacobians[1]} = weight_ * (rotation.conjugate() * rotated);
    }
    if (jacobians[2] != nullptr) jacobians[2][0] = -weight_;
    return true;
  }

 private:
  Eigen::Vector3d x_in_cam_;
  double weight_;
};

}  // namespace

ceres::CostFunction* MakeTiltCost(const Eigen::Quaterniond& base_from_cam, double sigma_rad) {
  return new TiltCost(base_from_cam, sigma_rad);
}

ceres::CostFunction* MakeHeightCost(const Eigen::Vector3d& x_in_cam, double sigma) {
  return new HeightCost(x_in_cam, sigma);
}

}  // namespace rovio_sfm
