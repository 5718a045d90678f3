#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <utility>

#include "rovio_sfm/scene/frame_store.h"

namespace rovio_sfm {

// A store of bounded size: forgets the frame that was longest not asked for, and fetches it again
// (from a file, from another node) when it is wanted. Thread-compatible; Get fetches too.
class FrameCache final : public FrameStore {
 public:
  // Null where a frame cannot be had.
  using Fetch = std::function<std::shared_ptr<const FrameFeatures>(const FrameId&)>;

  // At least the newest frame is kept, whatever its size.
  FrameCache(size_t max_bytes, Fetch fetch) : max_bytes_(max_bytes), fetch_(std::move(fetch)) {}

  void Put(const FrameEvent& event) override;
  void Put(const FrameId& id, std::shared_ptr<const FrameFeatures> features);
  std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const override;

  size_t NumBytes() const { return num_bytes_; }
  uint64_t NumFetched() const { return num_fetched_; }

 private:
  struct Entry {
    FrameId id;
    std::shared_ptr<const FrameFeatures> features;
  };

  void Keep(const FrameId& id, std::shared_ptr<const FrameFeatures> features) const;

  const size_t max_bytes_;
  const Fetch fetch_;
  // A cache is the same to its reader, whatever it holds.
  mutable std::list<Entry> entries_;  // the one asked for last is first
  mutable std::map<FrameId, std::list<Entry>::iterator> by_id_;
  mutable size_t num_bytes_ = 0;
  mutable uint64_t num_fetched_ = 0;
};

}  // namespace rovio_sfm
