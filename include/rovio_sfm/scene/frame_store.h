#pragma once

#include <memory>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// What frames brought, by frame; the only way by which a mapper reaches features and descriptors,
// so that they may live in memory or in a file.
class FrameStore {
 public:
  virtual ~FrameStore() = default;
  // Takes a frame that its mapper has accepted. A frame that is put again is replaced.
  virtual void Put(const FrameEvent& event) = 0;
  // Of a keyframe; null if it is unknown.
  virtual std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const = 0;
};

}  // namespace rovio_sfm
