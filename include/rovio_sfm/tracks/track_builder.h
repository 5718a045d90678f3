#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/tracks/filter_f1.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

struct TrackOptions {
  double same_feature_px = 1.5;
  int remembered_frames = 40;

  void DescribeOptions(OptionTable& table) {
    table.AddLiveNumber("same_feature_px", same_feature_px, 0.0, 100.0, "nearer features are one");
    table.AddNumber("remembered_frames", remembered_frames, 1, 10000, "matches reach back so far");
  }
};

// What happened to the matches of one keyframe (Table 3.5).
struct TrackCounts {
  uint32_t new_tracks = 0;  // features that began a track
  uint32_t extended = 0;    // features that joined a track (cases 1 to 3)
  uint32_t agreed = 0;      // matches between features of one track already
  uint32_t linked = 0;      // matches that joined two tracks (cases 4 to 6)
  uint32_t duplicates = 0;  // features that count as one with another of their frame and track
  uint32_t refused_f1 = 0;  // matches dropped by filter f1
  uint32_t unknown = 0;     // matches with a frame no longer remembered
};

struct TrackUpdate {
  std::vector<TrackId> tracks;  // one per keypoint; 0 for a duplicate of another keypoint
  std::vector<std::pair<TrackId, TrackId>> links;  // tracks found to be one; smaller id first
  TrackCounts counts;
};

// Builds the tracks of one drive from the verified matches of its keyframes (§3.6, Table 3.5).
// Every feature begins a track of its own or joins that of the earlier feature it matches; ids
// start at 1 and never change once returned. A match between features of two tracks gives a link,
// unless filter f1 forbids it; then only that match is dropped. Remembers a bounded number of
// keyframes. Thread-compatible.
class TrackBuilder {
 public:
  explicit TrackBuilder(const TrackOptions& options);

  // From the next keyframe on.
  void SetOptions(const TrackOptions& options);

  // Adds a keyframe; frame_index must grow. Pairs come nearest frame first; feature indices of
  // their inliers must be valid.
  TrackUpdate Add(uint32_t frame_index, const std::vector<Eigen::Vector2f>& keypoints_px,
                  const std::vector<PairMatches>& pairs);

 private:
  struct FrameTable {
    uint32_t index = 0;
    std::vector<Eigen::Vector2f> keypoints_px;
    std::vector<TrackId> tracks;  // by feature, always roots; duplicates hold their track too
  };

  FrameTable* FindFrame(uint32_t index);
  void AddMatch(TrackId track_a, uint32_t feature_b, FrameTable* frame, TrackUpdate* update);
  void Join(TrackId track, uint32_t feature, FrameTable* frame, TrackUpdate* update);
  void Link(TrackId a, TrackId b, FrameTable* frame, TrackUpdate* update);
  void Unite(TrackId kept, TrackId gone, FrameTable* frame);
  void BeginTracks(FrameTable* frame, TrackUpdate* update);
  void ForgetOldFrames();

  TrackOptions options_;
  TrackId next_track_ = 1;
  std::deque<FrameTable> frames_;  // ascending index; oldest dropped beyond remembered_frames
  std::unordered_map<TrackId, std::vector<TrackMember>> members_;  // by root; sorted; look-up only
};

}  // namespace rovio_sfm
