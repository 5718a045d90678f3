#include "rovio_sfm/pipeline/update_scale.h"

#include <cmath>
#include <vector>

#include "rovio_sfm/pipeline/odometry_gate.h"
#include "rovio_sfm/sfm/estimate_scale.h"

namespace rovio_sfm {
namespace {

std::vector<ScaleSample> SamplesOf(const Session& session) {
  std::vector<ScaleSample> samples;
  for (const auto& [index, frame] : session.keyframes()) {
    const auto odom_from_camera = OdomFromCamera(frame.odometry, frame.base_from_camera);
    if (frame.weak || !odom_from_camera) continue;
    samples.push_back({frame.cam_from_session, *odom_from_camera, frame.odometry->yaw_rad});
  }
  return samples;
}

}  // namespace

bool UpdateScale(const ScaleOptions& options, bool adopt, Session* session) {
  const EstimateScaleOptions estimate{options.min_distance_m,
                                      options.max_rotation_gap_deg * M_PI / 180.0,
                                      options.odometry_gain_sigma, options.sideways_sigma};
  const auto scale = EstimateScale(SamplesOf(*session), estimate);
  if (!scale) return false;
  if (session->scale() && !adopt) {
    const double change = std::log(scale->metres_per_unit / session->scale()->metres_per_unit);
    if (std::abs(change) <= 2.0 * session->scale()->sigma_log) return false;
  }
  session->set_scale(*scale);
  return true;
}

}  // namespace rovio_sfm
