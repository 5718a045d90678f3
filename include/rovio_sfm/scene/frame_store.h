#pragma once

#include <memory>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// Features and descriptors by frame; the only way by which a mapper reaches them, so that they may
// live in memory or in a file.
class FrameStore {
 public:
  virtual ~FrameStore() = default;
  virtual void Put(const FrameId& id, std::shared_ptr<const FrameFeatures> features) = 0;
  // Null if the frame is unknown.
  virtual std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const = 0;
};

}  // namespace rovio_sfm
