#pragma once

#include <rovio_sfm/FrameEventMsg.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "rovio_sfm/io/map_store.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// What frames brought: from the events that a node still holds, else from its store, through a
// connection of its own, opened when it is first wanted. For one thread.
class KeptFrames {
 public:
  // store: there need not be such a file.
  KeptFrames(std::map<FrameId, FrameEventMsg::ConstPtr> events, std::filesystem::path store)
      : events_(std::move(events)), file_(std::move(store)) {}

  // The encoded image; null: none is kept. Throws StoreError.
  std::shared_ptr<const std::vector<uint8_t>> ReadImage(const FrameId& id);
  // Features with descriptors; null: none are kept. Throws StoreError.
  std::shared_ptr<const FrameFeatures> ReadFeatures(const FrameId& id);

 private:
  FrameEventMsg::ConstPtr Held(const FrameId& id) const;  // null: let go
  MapStore* Store();                                      // null: there is none

  std::map<FrameId, FrameEventMsg::ConstPtr> events_;
  std::filesystem::path file_;
  std::unique_ptr<MapStore> store_;
};

}  // namespace rovio_sfm
