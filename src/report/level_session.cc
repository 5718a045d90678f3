#include "rovio_sfm/report/level_session.h"

#include <algorithm>

namespace rovio_sfm {

const SessionSnapshot* FindRoot(const MapSnapshot& snapshot) {
  for (const SessionSnapshot& session : snapshot.sessions) {
    if (LevelFromSession(session)) return &session;
  }
  return nullptr;
}

const SessionSnapshot* FindSession(const MapSnapshot& snapshot, SessionId id) {
  for (const SessionSnapshot& session : snapshot.sessions) {
    if (session.id == id) return &session;
  }
  return nullptr;
}

const FrameSnapshot* FindFrame(const SessionSnapshot& session, uint32_t index) {
  for (const auto& block : session.frames) {
    if (block->empty() || block->back().index < index) continue;
    const auto frame =
        std::lower_bound(block->begin(), block->end(), index,
                         [](const FrameSnapshot& f, uint32_t value) { return f.index < value; });
    return frame->index == index ? &*frame : nullptr;
  }
  return nullptr;
}

std::optional<Sim3> LevelInUnitOfMap(const SessionSnapshot& session) {
  const std::optional<Sim3> level_from_session = LevelFromSession(session);
  if (!level_from_session || session.scale) return level_from_session;
  const Sim3 map_unit_from_unit{session.map_from_session.scale, Eigen::Quaterniond::Identity(),
                                Eigen::Vector3d::Zero()};
  return map_unit_from_unit * *level_from_session;
}

std::optional<Rigid3> CameraInLevel(const SessionSnapshot& session, const FrameSnapshot& frame) {
  const std::optional<Sim3> level_from_session = LevelInUnitOfMap(session);
  if (!level_from_session) return std::nullopt;
  return Inverse(TransformCamera(*level_from_session, frame.cam_from_session));
}

}  // namespace rovio_sfm
