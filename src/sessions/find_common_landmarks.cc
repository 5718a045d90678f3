#include "rovio_sfm/sessions/find_common_landmarks.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

// A landmark without parallax: its distance is as good as unknown, its direction is not.
constexpr double kUnknownLogDistance = 10.0;

const Keyframe* FindReference(const Session& session, const FrameId& frame) {
  if (frame.drive != session.drive()) return nullptr;
  const auto it = session.keyframes().find(frame.index);
  return it == session.keyframes().end() || it->second.weak ? nullptr : &it->second;
}

// Two rays of one sigma each that meet under the landmark's widest angle with the frame.
double SigmaLogDistance(const Session& session, const Landmark& landmark, const Keyframe& frame,
                        double sigma) {
  const Eigen::Vector3d center = OriginInA(frame.cam_from_session);
  double widest_rad = 0.0;
  for (const Observation& observation : landmark.observations) {
    const Eigen::Vector3d other = OriginInA(session.keyframe(observation.frame).cam_from_session);
    widest_rad = std::max(widest_rad, ParallaxAngle(center, other, landmark.position));
  }
  return std::min(kUnknownLogDistance,
                  std::sqrt(2.0) * sigma / std::sin(std::min(widest_rad, M_PI_2)));
}

CrossView ViewOf(const Session& session, uint32_t index, const Keyframe& frame, uint32_t feature) {
  CrossView view{{index, feature},      frame.tracks[feature], frame.cam_from_session,
                 frame.points[feature], frame.sigmas[feature], {}};
  const Landmark* landmark = frame.observed[feature] ? session.FindLandmark(view.track) : nullptr;
  if (landmark != nullptr) {
    view.landmark =
        SeenLandmark{landmark->position, SigmaLogDistance(session, *landmark, frame, view.sigma)};
  }
  return view;
}

}  // namespace

std::vector<CrossMatch> FindCrossMatches(const Session& a, const Session& b, const FrameId& frame_a,
                                         const FrameId& frame_b,
                                         const std::vector<FeatureMatch>& matches) {
  const Keyframe* keyframe_a = FindReference(a, frame_a);
  const Keyframe* keyframe_b = FindReference(b, frame_b);
  if (keyframe_a == nullptr || keyframe_b == nullptr) return {};
  std::vector<CrossMatch> found;
  for (const FeatureMatch& match : matches) {
    if (match.a >= keyframe_a->points.size() || match.b >= keyframe_b->points.size()) continue;
    found.push_back({ViewOf(a, frame_a.index, *keyframe_a, match.a),
                     ViewOf(b, frame_b.index, *keyframe_b, match.b)});
  }
  return found;
}

}  // namespace rovio_sfm
