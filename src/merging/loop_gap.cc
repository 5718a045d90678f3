#include "rovio_sfm/merging/loop_gap.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rovio_sfm/util/median.h"

namespace rovio_sfm {

LoopGap MeasureGap(const Session& b, uint32_t frame, const Sim3& measured_b_from_a,
                   const Sim3& known_b_from_a) {
  const Sim3 gap = measured_b_from_a * Inverse(known_b_from_a);
  const Eigen::Vector3d centre = OriginInA(b.keyframe(frame).cam_from_session);
  return {(gap * centre - centre).norm(), std::log(gap.scale), RotationAngle(gap.rotation)};
}

double PathLength(const Session& session, uint32_t first, uint32_t last) {
  double length = 0.0;
  const auto end = session.keyframes().upper_bound(last);
  auto it = session.keyframes().lower_bound(first);
  if (it == session.keyframes().end()) return length;
  Eigen::Vector3d before = OriginInA(it->second.cam_from_session);
  for (; it != end; ++it) {
    const Eigen::Vector3d centre = OriginInA(it->second.cam_from_session);
    length += (centre - before).norm();
    before = centre;
  }
  return length;
}

double MedianDepth(const Session& session, uint32_t frame) {
  const Keyframe& keyframe = session.keyframe(frame);
  std::vector<double> depths;
  for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
    if (!keyframe.observed[i]) continue;
    const Landmark& landmark = session.landmarks().at(keyframe.tracks[i]);
    depths.push_back((keyframe.cam_from_session * landmark.position).z());
  }
  if (depths.empty()) return 0.0;
  return Median(std::move(depths));
}

}  // namespace rovio_sfm
