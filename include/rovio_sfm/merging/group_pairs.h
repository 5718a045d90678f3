#pragma once

#include <map>
#include <vector>

#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session_table.h"

namespace rovio_sfm {

using PairsBySession = std::map<SessionId, std::vector<OverlapPair>>;

// The pairs of a match by the session that holds their frames; those that none holds are left out.
PairsBySession GroupPairs(const PlaceMatch& match, const SessionTable& sessions);

// The session that shares most with the query; ties go to the smaller id. Pairs must not be empty.
SessionId FindRichest(const PairsBySession& pairs);

}  // namespace rovio_sfm
