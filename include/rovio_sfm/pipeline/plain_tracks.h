#pragma once
#include <map>
#include <set>
#include <vector>

#include "rovio_sfm/pipeline/events.h"
namespace rovio_sfm {
struct PlainTrackOptions {
  bool IsValid(std::string*) const { return true; }
};
struct PlainTracks {
  std::vector<TrackId> tracks;
  std::vector<TrackLink> links;
};
// Stands in until tracks/track_builder.h lands.
class PlainTrackBuilder {
 public:
  explicit PlainTrackBuilder(const PlainTrackOptions&) {}
  PlainTracks Add(uint32_t index, const FrameFeatures& f, const std::vector<PairMatches>& pairs) {
    PlainTracks r;
    r.tracks.assign(f.keypoints.size(), 0);
    std::set<TrackId> used;
    for (const auto& p : pairs)
      for (const auto& m : p.inliers) {
        TrackId t = frames_[p.other_index][m.a];
        if (r.tracks[m.b] == 0) {
          if (used.insert(t).second) r.tracks[m.b] = t;
        } else if (r.tracks[m.b] != t && !used.count(t)) {
          r.links.push_back({std::min(t, r.tracks[m.b]), std::max(t, r.tracks[m.b])});
          used.insert(t);
        }
      }
    for (auto& t : r.tracks)
      if (t == 0) t = next_++;
    frames_[index] = r.tracks;
    return r;
  }

 private:
  std::map<uint32_t, std::vector<TrackId>> frames_;
  TrackId next_ = 1;
};
}  // namespace rovio_sfm
