#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// What a keyframe may not be matched with in its own drive.
struct RecentPastOptions {
  int min_keyframes = 20;
  int min_shared_tracks = 5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("min_keyframes", min_keyframes, 1, 10000, "the newest ones of the drive");
    table.AddNumber("min_shared_tracks", min_shared_tracks, 1, 1000,
                    "and those back to where so many of its tracks began");
  }
};

// The recent past of a drive: never time, the robot may stand. It does not reach back over a break,
// a keyframe that shares no tracks with any before it: what was lost there is to be found again.
// Thread-compatible; memory is bounded.
class RecentPast {
 public:
  explicit RecentPast(const RecentPastOptions& options) : options_(options) {}

  // Takes in the drive's next keyframe. Returns how many of the keyframes before it, counted from
  // the drive's first, do not belong to its recent past.
  size_t Add(const std::vector<TrackId>& tracks, const std::vector<TrackLink>& links);

  // The drive was lost: all but its newest num_kept keyframes are to be found again.
  void Break(size_t num_kept) {
    chain_begin_ = num_keyframes_ > num_kept ? num_keyframes_ - num_kept : 0;
  }

 private:
  struct Span {
    size_t first = 0, last = 0;  // keyframes that showed the track, counted from 0
  };

  void Join(const TrackLink& link);
  size_t BeginningOf(const std::vector<TrackId>& tracks) const;
  void Show(const std::vector<TrackId>& tracks);

  RecentPastOptions options_;
  std::map<TrackId, Span> spans_;  // of the tracks seen lately
  size_t num_keyframes_ = 0;
  size_t chain_begin_ = 0;  // the keyframe after the last break
};

}  // namespace rovio_sfm
