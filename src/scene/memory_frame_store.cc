#include "rovio_sfm/scene/memory_frame_store.h"

#include <utility>

namespace rovio_sfm {

void MemoryFrameStore::Put(const FrameEvent& event) {
  if (event.kind == FrameKind::kKeyframe) Put(event.id, event.features);
}

void MemoryFrameStore::Put(const FrameId& id, std::shared_ptr<const FrameFeatures> features) {
  frames_[id] = std::move(features);
}

std::shared_ptr<const FrameFeatures> MemoryFrameStore::Get(const FrameId& id) const {
  const auto it = frames_.find(id);
  return it == frames_.end() ? nullptr : it->second;
}

}  // namespace rovio_sfm
