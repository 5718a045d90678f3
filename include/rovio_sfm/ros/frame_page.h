#pragma once

#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/GetFrames.h>

#include <cstddef>
#include <cstdint>

namespace rovio_sfm {

constexpr uint32_t kMaxPageFrames = 100;
constexpr size_t kMaxPageBytes = 16u << 20;

// One answer of get_frames, bounded in frames and bytes. A page's first frame fits whatever its
// size: who asks must come on.
class FramePage {
 public:
  // At most kMaxPageFrames, whatever is asked for.
  explicit FramePage(uint32_t max_frames);

  // False where the event does not fit any more: it is what to ask for next.
  bool Add(const FrameEventMsg& event);
  // The frames, with status OK; NOT_FOUND with this sentence where there are none.
  GetFramesResponse Take(const char* none);

 private:
  uint32_t max_frames_;
  size_t num_bytes_ = 0;
  GetFramesResponse response_;
};

}  // namespace rovio_sfm
