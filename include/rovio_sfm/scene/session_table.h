#pragma once

#include <map>
#include <memory>
#include <vector>

#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// All sessions by id. The keeper of the maps owns it (merging/map_keeper.h) and lends a session to
// the step that changes it; everybody else reads. Sessions stay where they are.
class SessionTable {
 public:
  // A session of the drive, with the next id.
  Session& Open(const DriveId& drive, const Camera& camera);
  // Takes a session that was mapped elsewhere; its id must be free.
  Session& Adopt(Session session);

  const Session* Find(SessionId id) const;  // null: unknown
  Session* Lend(SessionId id);              // to be changed; null: unknown
  // The session of the drive that was opened last, to be changed; null: none.
  Session* FindNewest(const DriveId& drive);
  // The session in which the frame is a keyframe with a pose of its own; null if there is none.
  const Session* FindHolder(const FrameId& id) const;

  const std::map<SessionId, std::unique_ptr<Session>>& all() const { return sessions_; }

 private:
  std::map<SessionId, std::unique_ptr<Session>> sessions_;
  std::map<DriveId, std::vector<const Session*>> by_drive_;
};

}  // namespace rovio_sfm
