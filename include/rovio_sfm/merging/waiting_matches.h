#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/scene/place_match.h"

namespace rovio_sfm {

// A place match whose frames, poses or scale are not there yet.
struct WaitingMatch {
  PlaceMatch match;
  int age = 0;  // keyframes
  std::string reason;
  bool needs_scale = false;  // not tried again before both sessions know theirs, or have ended
};

// Place matches in the order in which they came, each tried again until it is settled or too old.
class WaitingMatches {
 public:
  static constexpr size_t kCapacity = 2000;  // the oldest gives up for one more

  using Try = std::function<bool(WaitingMatch*)>;  // true: settled
  using GiveUp = std::function<void(const WaitingMatch&)>;

  void Add(WaitingMatch entry, const GiveUp& give_up);
  // Tries each; gives up those that have waited for more than `patience` keyframes.
  void Advance(int patience, const Try& try_now, const GiveUp& give_up);
  void Clear(const GiveUp& give_up);

  // True where one of them holds these two frames, whichever is its query.
  bool HoldsBoth(const FrameId& a, const FrameId& b) const;
  // All of them, and those whose query is a frame of the drive.
  std::vector<PlaceMatch> All() const;
  std::vector<PlaceMatch> OfDrive(const DriveId& drive) const;
  size_t size() const { return entries_.size(); }

 private:
  std::deque<WaitingMatch> entries_;
};

}  // namespace rovio_sfm
