#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/tracks/filter_f2.h"

namespace rovio_sfm {

struct LinkReport {
  uint32_t num_united = 0;
  uint32_t num_refused_f1 = 0;  // two features in one frame
};

// Unites the linked tracks (design 5.2.3): f1 decides first; where both have landmarks f2 does.
// Links that fail f2 are left in `pending`, to be tried again after the next adjustment; the others
// leave it.
LinkReport LinkTracks(const FilterF2Options& f2, std::vector<TrackLink>* pending, Session* session);

// f2 and the union of two landmarks; false if refused.
bool TryUniteLandmarks(TrackId a, TrackId b, const FilterF2Options& f2, Session* session);

}  // namespace rovio_sfm
