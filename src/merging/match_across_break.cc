#include "rovio_sfm/merging/match_across_break.h"

#include <algorithm>
#include <map>
#include <utility>

namespace rovio_sfm {
namespace {

using MatchesByFrame = std::map<uint32_t, std::vector<FeatureMatch>>;

// The keyframe's features whose tracks keyframes of `before` show.
MatchesByFrame SharedWith(const Session& before, const Keyframe& keyframe) {
  MatchesByFrame matches;
  for (uint32_t feature = 0; feature < keyframe.tracks.size(); ++feature) {
    if (keyframe.tracks[feature] == 0) continue;
    const auto track = before.tracks().find(before.RootOf(keyframe.tracks[feature]));
    if (track == before.tracks().end()) continue;
    for (const Observation& member : track->second.members) {
      if (before.keyframe(member.frame).weak) continue;
      matches[member.frame].push_back({member.feature, feature});
    }
  }
  return matches;
}

}  // namespace

std::vector<PlaceMatch> MatchAcrossBreak(const Session& before, const Session& after) {
  std::vector<PlaceMatch> found;
  for (const auto& [index, keyframe] : after.keyframes()) {
    if (keyframe.weak) continue;
    PlaceMatch match;
    match.query = {after.drive(), index};
    match.probability = 1.0;
    for (auto& [frame, inliers] : SharedWith(before, keyframe)) {
      if (inliers.size() < kMinSharedTracks) continue;
      match.pairs.push_back(
          {{before.drive(), frame}, PairVerdict::kGeneral, {}, std::move(inliers)});
    }
    if (match.pairs.empty()) continue;
    std::stable_sort(match.pairs.begin(), match.pairs.end(), [](const auto& a, const auto& b) {
      return a.inliers.size() > b.inliers.size();
    });
    found.push_back(std::move(match));
  }
  return found;
}

size_t CountSharedTracks(const Session& a, uint32_t frame_a, const Session& b, uint32_t frame_b) {
  if (a.drive() != b.drive()) return 0;
  const auto shared = SharedWith(a, b.keyframe(frame_b));
  const auto of_frame = shared.find(frame_a);
  return of_frame == shared.end() ? 0 : of_frame->second.size();
}

}  // namespace rovio_sfm
