#include "rovio_sfm/ros/kept_frames.h"

#include <string>

#include "rovio_sfm/ros/frame_event_message.h"

namespace rovio_sfm {

FrameEventMsg::ConstPtr KeptFrames::Held(const FrameId& id) const {
  const auto event = events_.find(id);
  return event == events_.end() ? nullptr : event->second;
}

MapStore* KeptFrames::Store() {
  if (!store_ && std::filesystem::exists(file_)) {
    store_ = std::make_unique<MapStore>(file_, StoreAccess::kRead);
  }
  return store_.get();
}

std::shared_ptr<const std::vector<uint8_t>> KeptFrames::ReadImage(const FrameId& id) {
  const FrameEventMsg::ConstPtr held = Held(id);
  if (held && !held->jpeg.empty()) return {&held->jpeg, [held](const std::vector<uint8_t>*) {}};
  return Store() == nullptr ? nullptr : Store()->frames().ReadImage(id);
}

std::shared_ptr<const FrameFeatures> KeptFrames::ReadFeatures(const FrameId& id) {
  if (const FrameEventMsg::ConstPtr held = Held(id)) {
    std::string error;
    const auto event = FromMessage(*held, &error);  // it was taken before
    return event ? event->features : nullptr;
  }
  return Store() == nullptr ? nullptr : Store()->Get(id);
}

}  // namespace rovio_sfm
