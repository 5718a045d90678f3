#include "rovio_sfm/scene/map_snapshot.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {
namespace {

// Axes of a body (x forward, y left, z up) from those of a camera (z forward, x right, y down).
Rigid3 BaseFromLevelCamera(double camera_pitch_rad) {
  Eigen::Matrix3d body_from_optical;
  body_from_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Eigen::AngleAxisd pitch(camera_pitch_rad, Eigen::Vector3d::UnitY());
  return {Eigen::Quaterniond(pitch * body_from_optical), Eigen::Vector3d::Zero()};
}

// The frame that says what is level: of the first block of frames the first whose head is known,
// else the first. A live drive's first images may come before the head's transform does.
const FrameSnapshot* LevelFrame(const SessionSnapshot& session) {
  for (const auto& block : session.frames) {
    if (block->empty()) continue;
    const auto known = std::find_if(block->begin(), block->end(), [](const FrameSnapshot& frame) {
      return frame.base_from_camera.has_value();
    });
    return known != block->end() ? &*known : &block->front();
  }
  return nullptr;
}

}  // namespace

std::optional<Sim3> LevelFromSession(const SessionSnapshot& session, double camera_pitch_rad) {
  const FrameSnapshot* frame = LevelFrame(session);
  if (frame == nullptr) return std::nullopt;
  const double scale = session.scale ? session.scale->metres_per_unit : 1.0;
  Rigid3 base_from_camera = BaseFromLevelCamera(camera_pitch_rad);
  // A lever arm in metres has no meaning beside map units: only its direction of view counts then.
  if (frame->base_from_camera) base_from_camera.rotation = frame->base_from_camera->rotation;
  if (frame->base_from_camera && session.scale) base_from_camera = *frame->base_from_camera;
  const Sim3 cam_from_session{scale, frame->cam_from_session.rotation,
                              scale * frame->cam_from_session.translation};
  return Sim3{1.0, base_from_camera.rotation, base_from_camera.translation} * cam_from_session;
}

}  // namespace rovio_sfm
