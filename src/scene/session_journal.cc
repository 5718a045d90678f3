#include "rovio_sfm/scene/session_journal.h"

namespace rovio_sfm {
namespace {

template <typename T>
size_t BytesOf(const std::vector<T>& entries) {
  return entries.capacity() * sizeof(T);
}

template <typename Key, typename Part>
size_t BytesOf(const SessionEpoch::Parts<Key, Part>& parts) {
  return parts.capacity() * sizeof(parts[0]) + parts.size() * sizeof(Part);
}

}  // namespace

size_t SessionEpoch::NumBytes() const {
  return sizeof(*this) + BytesOf(poses) + BytesOf(light_poses) + BytesOf(members) +
         positions.NumBytes() + BytesOf(landmarks) + BytesOf(keyframes) + BytesOf(light_frames) +
         BytesOf(aliases);
}

void SessionEpoch::Shrink() {
  poses.shrink_to_fit();
  light_poses.shrink_to_fit();
  members.shrink_to_fit();
  positions.Shrink();
  landmarks.shrink_to_fit();
  keyframes.shrink_to_fit();
  light_frames.shrink_to_fit();
  aliases.shrink_to_fit();
}

}  // namespace rovio_sfm
