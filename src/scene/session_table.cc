#include "rovio_sfm/scene/session_table.h"

#include <utility>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

Session& SessionTable::Open(const DriveId& drive, const Camera& camera) {
  const uint32_t last = sessions_.empty() ? 0 : sessions_.rbegin()->first.value;
  return Adopt(Session({last + 1}, drive, camera));
}

Session& SessionTable::Adopt(Session session) {
  auto& entry = sessions_[session.id()];
  ROVIO_CHECK(entry == nullptr, "two sessions with one id");
  entry = std::make_unique<Session>(std::move(session));
  by_drive_[entry->drive()].push_back(entry.get());
  return *entry;
}

const Session* SessionTable::Find(SessionId id) const {
  const auto it = sessions_.find(id);
  return it == sessions_.end() ? nullptr : it->second.get();
}

Session* SessionTable::Lend(SessionId id) {
  const auto it = sessions_.find(id);
  return it == sessions_.end() ? nullptr : it->second.get();
}

Session* SessionTable::FindNewest(const DriveId& drive) {
  const auto sessions = by_drive_.find(drive);
  return sessions == by_drive_.end() ? nullptr : Lend(sessions->second.back()->id());
}

const Session* SessionTable::FindHolder(const FrameId& id) const {
  const auto drive = by_drive_.find(id.drive);
  if (drive == by_drive_.end()) return nullptr;
  for (const Session* session : drive->second) {
    const auto frame = session->keyframes().find(id.index);
    if (frame != session->keyframes().end() && !frame->second.weak) return session;
  }
  return nullptr;
}

}  // namespace rovio_sfm
