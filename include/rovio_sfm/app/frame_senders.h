#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// Where a frame came from; it goes with the event.
struct FrameOrigin {
  std::string sender;          // name of the node at the other end of the connection
  bool is_only_sender = true;  // nobody else is connected for this robot
  double arrived_s = 0.0;      // steady time
};

// Who may begin a robot's next drive. While the sender of the drive that runs is there and was
// heard within the last seconds, frames of other drives from other senders (a second frontend with
// the name, a stray message) are refused; a sender's own next drive begins at once.
// Thread-compatible; reads no clock.
class FrameSenders {
 public:
  static constexpr double kSilenceS = 5.0;

  // Why the frame is refused; nothing where it may go on.
  std::optional<std::string> RefusalOf(const DriveId& drive, const FrameOrigin& origin);

  uint64_t num_refused() const { return num_refused_; }

 private:
  struct Owner {
    DriveId drive;
    std::string sender;
    double heard_s = 0.0;
  };

  std::map<std::string, Owner> owners_;  // by robot
  uint64_t num_refused_ = 0;
};

}  // namespace rovio_sfm
