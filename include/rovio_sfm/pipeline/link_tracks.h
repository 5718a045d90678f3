#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/pipeline/events.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

struct LinkReport {
  uint32_t num_united = 0;
  uint32_t num_refused_f1 = 0;  // two features in one frame
};

// Unites the linked tracks (design 5.2.3): f1 decides first; where both have landmarks f2 does, by
// the reprojection of the united point, the mean weighted by (views - 1), into all views of both.
// Links that fail f2 are left in `pending`, to be tried again after the next adjustment; the others
// leave it.
LinkReport LinkTracks(double max_error_sigmas, std::vector<TrackLink>* pending, Session* session);

// f2 and the union of two landmarks; false if refused.
bool TryUniteLandmarks(TrackId a, TrackId b, double max_error_sigmas, Session* session);

}  // namespace rovio_sfm
