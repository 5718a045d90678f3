#include "rovio_sfm/ros/event_history.h"

#include <ros/serialization.h>

#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/frame_page.h"
#include "rovio_sfm/ros/status.h"

namespace rovio_sfm {
namespace {

size_t SizeOf(const FrameEventMsg& event) { return ros::serialization::serializationLength(event); }

bool IsOfDrive(const FrameEventMsg& event, const DriveIdMsg& drive) {
  return event.id.drive.robot == drive.robot && event.id.drive.start == drive.start &&
         event.id.drive.nonce == drive.nonce;
}

}  // namespace

void EventHistory::Add(FrameEventMsg::ConstPtr event) {
  MutexLock lock(mutex_);
  num_bytes_ += SizeOf(*event);
  events_.push_back(std::move(event));
  while (events_.size() > max_events_ || (num_bytes_ > max_bytes_ && events_.size() > 1)) {
    num_bytes_ -= SizeOf(*events_.front());
    events_.pop_front();
  }
}

void EventHistory::Clear() {
  MutexLock lock(mutex_);
  events_.clear();
  num_bytes_ = 0;
}

std::map<FrameId, FrameEventMsg::ConstPtr> EventHistory::Events() const {
  std::map<FrameId, FrameEventMsg::ConstPtr> found;
  MutexLock lock(mutex_);
  for (const FrameEventMsg::ConstPtr& event : events_) {
    std::string error;
    const auto id = FromMessage(event->id, &error);
    if (id) found[*id] = event;
  }
  return found;
}

GetFramesResponse EventHistory::Page(const GetFramesRequest& request) const {
  GetFramesResponse response;
  std::string error;
  if (!FromMessage(request.first, &error)) {
    response.status = InvalidArgument("first." + error);
    return response;
  }
  if (request.max_frames < 1 || request.max_frames > kMaxPageFrames) {
    response.status = InvalidArgument("max_frames = " + std::to_string(request.max_frames) +
                                      ": expected 1 to 100");
    return response;
  }
  FramePage page(request.max_frames);
  MutexLock lock(mutex_);
  for (const FrameEventMsg::ConstPtr& event : events_) {
    if (!IsOfDrive(*event, request.first.drive) || event->id.index < request.first.index) continue;
    if (!page.Add(*event)) break;
  }
  return page.Take("no frame of that drive from that index on is held");
}

}  // namespace rovio_sfm
