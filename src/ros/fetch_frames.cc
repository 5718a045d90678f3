#include "rovio_sfm/ros/fetch_frames.h"

#include <optional>
#include <string>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/frame_event_message.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kPageEvents = 20;  // of one call

enum class Reach { kBehind, kThere, kSilent };

Reach ReachOf(const CallGetFrames& call, const FrameId& id) {
  GetFramesRequest request;
  GetFramesResponse response;
  request.first = ToMessage(id);
  request.max_frames = 1;
  if (!call(request, response)) return Reach::kSilent;
  return response.frames.empty() ? Reach::kBehind : Reach::kThere;
}

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

uint32_t FetchFramesOfFollower(const CallGetFrames& call, const FrameId& first, uint32_t end,
                               const HandleFrame& handle, const std::function<bool()>& pause) {
  uint32_t done = first.index;
  while (done < end) {
    const Reach reach = ReachOf(call, {first.drive, end});  // before: what it then holds is whole
    if (reach == Reach::kSilent) break;
    done = FetchFrames(call, {first.drive, done}, end, handle);
    if (reach == Reach::kThere || done >= end || !pause()) break;
  }
  return done;
}

}  // namespace rovio_sfm
