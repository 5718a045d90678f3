#include "rovio_sfm/mapping/weak_pose.h"

#include <cmath>
#include <iterator>

#include "rovio_sfm/mapping/register_frame.h"

namespace rovio_sfm {
namespace {

std::optional<double> BaselineFromOdometry(const FrameEvent& event, const Keyframe& other,
                                           const Session& session) {
  if (!session.scale() || !event.odometry || !other.odometry) return std::nullopt;
  return std::hypot(event.odometry->x_m - other.odometry->x_m,
                    event.odometry->y_m - other.odometry->y_m) /
         session.scale()->metres_per_unit;
}

std::optional<double> LastBaseline(const Session& session) {
  if (session.keyframes().size() < 2) return std::nullopt;
  const auto last = std::prev(session.keyframes().end());
  return (OriginInA(last->second.cam_from_session) -
          OriginInA(std::prev(last)->second.cam_from_session))
      .norm();
}

}  // namespace

std::optional<Rigid3> PredictWeakPose(const FrameEvent& event, const Session& session) {
  for (const PairMatches& pair : event.pairs) {
    const auto other = session.keyframes().find(pair.other_index);
    if (other == session.keyframes().end() || pair.verdict == PairVerdict::kFailed) continue;
    auto baseline = BaselineFromOdometry(event, other->second, session);
    if (!baseline) baseline = LastBaseline(session);
    if (!baseline) return std::nullopt;
    Rigid3 cam_from_other = pair.cam_from_other;
    cam_from_other.translation *= *baseline;
    return cam_from_other * other->second.cam_from_session;
  }
  return std::nullopt;
}

bool ResectWeakFrame(uint32_t index, const MapperOptions& options, Session* session) {
  if (session->keyframes().count(index) == 0) return false;
  const auto registration = RegisterAgain(index, options, *session);
  if (!registration) return false;
  session->SetPose(index, registration->cam_from_session);
  session->SetWeak(index, false);
  return true;
}

}  // namespace rovio_sfm
