#include "rovio_sfm/recognition/recent_past.h"

#include <algorithm>

namespace rovio_sfm {
namespace {

constexpr size_t kForgetAfter = 100;  // keyframes without a track: more than a frontend looks back

}  // namespace

size_t RecentPast::Add(const std::vector<TrackId>& tracks, const std::vector<TrackLink>& links) {
  for (const TrackLink& link : links) Join(link);
  const size_t beginning = BeginningOf(tracks);
  if (beginning == num_keyframes_) chain_begin_ = num_keyframes_;
  const auto newest = static_cast<size_t>(options_.min_keyframes);
  const size_t by_count = num_keyframes_ > newest ? num_keyframes_ - newest : 0;
  Show(tracks);
  ++num_keyframes_;
  return std::max(chain_begin_, std::min(beginning, by_count));
}

void RecentPast::Join(const TrackLink& link) {
  const auto a = spans_.find(link.a);
  const auto b = spans_.find(link.b);
  if (a == spans_.end() || b == spans_.end()) return;
  a->second.first = b->second.first = std::min(a->second.first, b->second.first);
}

// The newest keyframe at or before which min_shared_tracks of the tracks began; the keyframe itself
// where fewer are older.
size_t RecentPast::BeginningOf(const std::vector<TrackId>& tracks) const {
  std::vector<size_t> beginnings;
  for (const TrackId track : tracks) {
    const auto span = spans_.find(track);
    if (span != spans_.end()) beginnings.push_back(span->second.first);
  }
  const auto count = static_cast<size_t>(options_.min_shared_tracks);
  if (beginnings.size() < count) return num_keyframes_;
  std::nth_element(beginnings.begin(), beginnings.begin() + static_cast<long>(count - 1),
                   beginnings.end());
  return beginnings[count - 1];
}

void RecentPast::Show(const std::vector<TrackId>& tracks) {
  for (const TrackId track : tracks) {
    if (track == 0) continue;
    const auto [span, is_new] = spans_.try_emplace(track, Span{num_keyframes_, num_keyframes_});
    if (!is_new) span->second.last = num_keyframes_;
  }
  for (auto span = spans_.begin(); span != spans_.end();) {
    span = span->second.last + kForgetAfter < num_keyframes_ ? spans_.erase(span) : std::next(span);
  }
}

}  // namespace rovio_sfm
