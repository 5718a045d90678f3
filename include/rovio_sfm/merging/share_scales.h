#pragma once

#include <optional>
#include <vector>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// Gives all sessions of a map one scale: the mean of the logarithms of theirs, weighted by inverse
// variance (design 5.4). A session without a scale gets that of its map; a map without any stays
// without.
void ShareScales(std::vector<SessionSnapshot>* sessions);

// By how many sigmas the scales of two sessions disagree, given where one lies in the other; 0
// where one has none.
double ScaleDisagreement(const std::optional<MapScale>& a, const std::optional<MapScale>& b,
                         const Sim3& b_from_a);

}  // namespace rovio_sfm
