#include "rovio_sfm/report/measure_odometry_delay.h"

#include <cmath>
#include <sstream>
#include <vector>

#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

constexpr double kWarnSigmas = 3.0, kWarnDelayS = 0.02;

TurnSample MakeSample(int64_t stamp_ns, const Rigid3& cam_from_map, const Rigid3& base_from_camera,
                      double odom_yaw_rad) {
  return {stamp_ns, (base_from_camera.rotation * cam_from_map.rotation).conjugate(), odom_yaw_rad};
}

std::vector<TurnSample> SamplesOf(const SessionSnapshot& session, const YawByStamp& yaws) {
  std::vector<TurnSample> samples;
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) {
      const auto yaw = yaws.find(frame.stamp_ns);
      if (frame.weak || !frame.base_from_camera || yaw == yaws.end()) continue;
      samples.push_back(
          MakeSample(frame.stamp_ns, frame.cam_from_session, *frame.base_from_camera, yaw->second));
    }
  }
  return samples;
}

}  // namespace

std::optional<OdometryDelay> MeasureOdometryDelay(const Session& session) {
  std::vector<TurnSample> samples;
  for (const auto& [index, frame] : session.keyframes()) {
    if (frame.weak || !frame.base_from_camera || !frame.odometry) continue;
    samples.push_back(MakeSample(frame.stamp_ns, frame.cam_from_session, *frame.base_from_camera,
                                 frame.odometry->yaw_rad));
  }
  return EstimateOdometryDelay(samples);
}

void UpdateOdometryDelay(Session* session) {
  const auto delay = MeasureOdometryDelay(*session);
  session->set_odometry_delay(delay);
  if (!delay) return;
  std::ostringstream text;
  text << "session " << session->id().value << ": odometry is stamped " << delay->delay_s
       << " s later than images (1 sigma " << delay->sigma_s
       << " s); so much more should odom_latency_s - image_latency_s be";
  const double size_s = std::abs(delay->delay_s);
  const bool matters = size_s > kWarnDelayS && size_s > kWarnSigmas * delay->sigma_s;
  matters ? LogWarning(text.str()) : LogInfo(text.str());
}

std::optional<OdometryDelay> MeasureOdometryDelay(const LevelMap& map,
                                                  const std::map<DriveId, YawByStamp>& yaws) {
  std::optional<OdometryDelay> best;
  for (const SessionSnapshot& session : map.sessions) {
    const auto drive = yaws.find(session.drive);
    if (drive == yaws.end()) continue;
    const auto delay = EstimateOdometryDelay(SamplesOf(session, drive->second));
    if (delay && (!best || delay->sigma_s < best->sigma_s)) best = delay;
  }
  return best;
}

}  // namespace rovio_sfm
