#include "rovio_sfm/ros/frame_page.h"

#include <ros/serialization.h>

#include <algorithm>
#include <string>
#include <utility>

#include "rovio_sfm/ros/status.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {

FramePage::FramePage(uint32_t max_frames) : max_frames_(std::min(max_frames, kMaxPageFrames)) {}

bool FramePage::Add(const FrameEventMsg& event) {
  num_bytes_ += ros::serialization::serializationLength(event);
  const bool is_first = response_.frames.empty();
  if (response_.frames.size() >= max_frames_ || (num_bytes_ > kMaxPageBytes && !is_first)) {
    response_.more = true;
    response_.next_index = event.id.index;
    return false;
  }
  response_.frames.push_back(event);
  return true;
}

GetFramesResponse FramePage::Take(const char* none) {
  response_.status =
      response_.frames.empty() ? NotFound(none) : Ok(CountText(response_.frames.size(), "frame"));
  return std::move(response_);
}

}  // namespace rovio_sfm
