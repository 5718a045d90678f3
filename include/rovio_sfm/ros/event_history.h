#pragma once

#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/GetFrames.h>

#include <deque>
#include <map>
#include <memory>

#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// The frame events that a node can still hand out, oldest first. Thread-safe.
class EventHistory {
 public:
  // Keeps at most so many events and so many bytes, dropping the oldest.
  EventHistory(size_t max_events, size_t max_bytes)
      : max_events_(max_events), max_bytes_(max_bytes) {}

  void Add(FrameEventMsg::ConstPtr event) EXCLUDES(mutex_);
  void Clear() EXCLUDES(mutex_);

  // All of them, by frame.
  std::map<FrameId, FrameEventMsg::ConstPtr> Events() const EXCLUDES(mutex_);

  // Answers the service GetFrames; never fails otherwise than by status.
  GetFramesResponse Page(const GetFramesRequest& request) const EXCLUDES(mutex_);

 private:
  const size_t max_events_;
  const size_t max_bytes_;
  mutable Mutex mutex_;
  std::deque<FrameEventMsg::ConstPtr> events_ GUARDED_BY(mutex_);
  size_t num_bytes_ GUARDED_BY(mutex_) = 0;
};

}  // namespace rovio_sfm
