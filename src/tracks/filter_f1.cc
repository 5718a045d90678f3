#include "rovio_sfm/tracks/filter_f1.h"

#include <algorithm>

namespace rovio_sfm {
namespace {

bool IsSameFeature(const TrackMember& a, const TrackMember& b, double max_distance_px) {
  return a.feature == b.feature || (a.x_px - b.x_px).norm() < max_distance_px;
}

}  // namespace

bool PassesFilterF1(const std::vector<TrackMember>& members_a,
                    const std::vector<TrackMember>& members_b, double max_distance_px) {
  auto first_b = members_b.begin();
  for (const TrackMember& a : members_a) {
    while (first_b != members_b.end() && first_b->frame < a.frame) ++first_b;
    for (auto b = first_b; b != members_b.end() && b->frame == a.frame; ++b) {
      if (!IsSameFeature(a, *b, max_distance_px)) return false;
    }
  }
  return true;
}

}  // namespace rovio_sfm
