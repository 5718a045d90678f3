#include "rovio_sfm/ros/fetch_frames.h"

#include <optional>
#include <string>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/frame_event_message.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kPageEvents = 20;  // of one call

}  // namespace

uint32_t FetchFrames(const CallGetFrames& call, const FrameId& first, uint32_t end,
                     const HandleFrame& handle) {
  GetFramesRequest request;
  GetFramesResponse response;
  uint32_t done = first.index;
  for (uint32_t next = first.index; next < end; next = response.next_index) {
    request.first = ToMessage(FrameId{first.drive, next});
    request.max_frames = kPageEvents;
    if (!call(request, response)) return done;
    for (const FrameEventMsg& message : response.frames) {
      std::string error;
      const std::optional<FrameEvent> event = FromMessage(message, &error);
      if (!event || event->id.drive != first.drive) continue;
      if (event->id.index < done || event->id.index >= end) continue;
      handle(message, *event);
      done = event->id.index + 1;
    }
    if (!response.more || response.next_index <= next) return done;
  }
  return done;
}

}  // namespace rovio_sfm
