#pragma once

#include <map>
#include <memory>

#include "rovio_sfm/scene/frame_store.h"

namespace rovio_sfm {

// Keeps the features of all keyframes in memory. Thread-compatible.
class MemoryFrameStore final : public FrameStore {
 public:
  void Put(const FrameEvent& event) override;
  void Put(const FrameId& id, std::shared_ptr<const FrameFeatures> features);
  std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const override;

 private:
  std::map<FrameId, std::shared_ptr<const FrameFeatures>> frames_;
};

}  // namespace rovio_sfm
