#include "rovio_sfm/mapping/update_scale.h"

#include <cmath>
#include <vector>

#include "rovio_sfm/sfm/estimate_floor_scale.h"
#include "rovio_sfm/sfm/estimate_scale.h"
#include "rovio_sfm/sfm/odometry_gate.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMinFloorViews = 3;
constexpr double kUnknownUpSigmaRad = 0.1;  // of a camera taken as level

std::optional<MapScale> ScaleFromOdometry(const ScaleOptions& options, const Session& session) {
  std::vector<ScaleSample> samples;
  std::vector<OdometrySample> odometry;
  for (const auto& [index, frame] : session.keyframes()) {
    const auto odom_from_camera = OdomFromCamera(frame.odometry, frame.base_from_camera);
    if (frame.weak || !odom_from_camera) continue;
    samples.push_back({frame.cam_from_session, *odom_from_camera, frame.odometry->yaw_rad});
    odometry.push_back(*frame.odometry);
  }
  const OdometryGains least{options.odometry_gain_sigma,
                            std::hypot(options.odometry_gain_sigma, options.sideways_sigma)};
  return EstimateScale(samples, {options.min_distance_m, Radians(options.max_rotation_gap_deg),
                                 LearnOdometryGains(odometry, least)});
}

// A camera whose head moved since the session's start is higher or lower by that much. Where the
// head's pose is unknown the camera is taken as level.
FloorCamera MakeFloorCamera(const Keyframe& frame, const Keyframe& first, double camera_height_m) {
  const Eigen::Quaterniond session_from_cam = frame.cam_from_session.rotation.conjugate();
  FloorCamera camera;
  camera.center_in_map = OriginInA(frame.cam_from_session);
  camera.up_in_map = session_from_cam * -Eigen::Vector3d::UnitY();
  camera.height_m = camera_height_m;
  if (!frame.base_from_camera || !first.base_from_camera) return camera;
  camera.up_in_map =
      session_from_cam * (frame.base_from_camera->rotation.conjugate() * Eigen::Vector3d::UnitZ());
  camera.height_m +=
      frame.base_from_camera->translation.z() - first.base_from_camera->translation.z();
  return camera;
}

std::optional<MapScale> ScaleFromCameraHeight(const ScaleOptions& options, const Session& session) {
  if (options.camera_height_m == 0.0 || session.keyframes().empty()) return std::nullopt;
  const Keyframe& first = session.keyframes().begin()->second;
  std::vector<FloorCamera> cameras;
  for (const auto& [index, frame] : session.keyframes()) {
    if (!frame.weak) cameras.push_back(MakeFloorCamera(frame, first, options.camera_height_m));
  }
  std::vector<Eigen::Vector3d> points;
  for (const auto& [id, landmark] : session.landmarks()) {
    if (landmark.observations.size() >= kMinFloorViews) points.push_back(landmark.position);
  }
  FloorUncertainty uncertainty{options.camera_height_sigma};
  if (!first.base_from_camera) uncertainty.up_sigma_rad = kUnknownUpSigmaRad;
  return EstimateFloorScale(cameras, points, uncertainty);
}

// The more certain of both.
std::optional<MapScale> BestScale(const ScaleOptions& options, const Session& session) {
  const auto by_odometry = ScaleFromOdometry(options, session);
  const auto by_height = ScaleFromCameraHeight(options, session);
  if (!by_odometry || !by_height) return by_odometry ? by_odometry : by_height;
  return by_height->sigma_log < by_odometry->sigma_log ? by_height : by_odometry;
}

}  // namespace

bool UpdateScale(const ScaleOptions& options, bool adopt, Session* session) {
  const std::optional<MapScale> scale = BestScale(options, *session);
  if (!scale) return false;
  if (session->scale() && !adopt) {
    const double change = std::log(scale->metres_per_unit / session->scale()->metres_per_unit);
    if (std::abs(change) <= 2.0 * session->scale()->sigma_log) return false;
  }
  session->set_scale(*scale);
  return true;
}

}  // namespace rovio_sfm
