#pragma once

#include <map>

#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// The sessions of all drives by id, lent by the mapper for one call.
class SessionTable {
 public:
  void Add(Session* session) { sessions_[session->id()] = session; }

  // Null if there is none.
  Session* Find(SessionId id) const {
    const auto it = sessions_.find(id);
    return it == sessions_.end() ? nullptr : it->second;
  }

  // The session in which the frame is a keyframe with a pose of its own; null if there is none.
  Session* FindHolder(const FrameId& id) const {
    for (const auto& [session_id, session] : sessions_) {
      if (!(session->drive() == id.drive)) continue;
      const auto frame = session->keyframes().find(id.index);
      if (frame != session->keyframes().end() && !frame->second.weak) return session;
    }
    return nullptr;
  }

  const std::map<SessionId, Session*>& all() const { return sessions_; }

 private:
  std::map<SessionId, Session*> sessions_;
};

}  // namespace rovio_sfm
