#include "rovio_sfm/scene/frame_cache.h"

namespace rovio_sfm {
namespace {

size_t BytesOf(const FrameFeatures& features) {
  return sizeof(FrameFeatures) + features.keypoints.size() * sizeof(Keypoint) +
         features.colors.size() * sizeof(Rgb) + features.descriptors.data.size();
}

}  // namespace

void FrameCache::Put(const FrameEvent& event) {
  if (event.kind == FrameKind::kKeyframe) Keep(event.id, event.features);
}

void FrameCache::Put(const FrameId& id, std::shared_ptr<const FrameFeatures> features) {
  Keep(id, std::move(features));
}

std::shared_ptr<const FrameFeatures> FrameCache::Get(const FrameId& id) const {
  const auto found = by_id_.find(id);
  if (found != by_id_.end()) {
    entries_.splice(entries_.begin(), entries_, found->second);
    return found->second->features;
  }
  std::shared_ptr<const FrameFeatures> features = fetch_ ? fetch_(id) : nullptr;
  if (features == nullptr) return nullptr;
  ++num_fetched_;
  Keep(id, features);
  return features;
}

void FrameCache::Keep(const FrameId& id, std::shared_ptr<const FrameFeatures> features) const {
  const auto old = by_id_.find(id);
  if (old != by_id_.end()) {
    num_bytes_ -= BytesOf(*old->second->features);
    entries_.erase(old->second);
    by_id_.erase(old);
  }
  num_bytes_ += BytesOf(*features);
  entries_.push_front({id, std::move(features)});
  by_id_[id] = entries_.begin();
  while (num_bytes_ > max_bytes_ && entries_.size() > 1) {
    num_bytes_ -= BytesOf(*entries_.back().features);
    by_id_.erase(entries_.back().id);
    entries_.pop_back();
  }
}

}  // namespace rovio_sfm
