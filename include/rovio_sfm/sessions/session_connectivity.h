#pragma once

#include <cstddef>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// An accepted merge.
struct SessionLink {
  SessionId a, b;
  Sim3 b_from_a;
  double weight = 1.0;  // of two ways to join sessions the one of heavier links counts: inliers
};

struct MapMember {
  SessionId session;
  Sim3 map_from_session;  // identity for the root
};

// A link that closes a cycle, or a loop within one session: what is left after going round.
struct CycleGap {
  size_t link = 0;            // into the links
  Sim3 a_from_a;              // along the tree after along the link; identity without contradiction
  double rotation_rad = 0.0;  // of a_from_a
  double log_scale = 0.0;
  double distance = 0.0;  // by which the origin of a moves, in map units of a
};

// Sessions that share one gauge, that of their root: the smallest id, which names the map.
struct ConnectedMap {
  MapId id;
  std::vector<MapMember> members;  // by id, the root first
  std::vector<CycleGap> gaps;      // by link
};

// The maps that the links make of the sessions, by id, along heaviest spanning trees. Sessions that
// only a link names count too. The same set of links gives the same maps in any order; undoing a
// merge is leaving its link out.
std::vector<ConnectedMap> ConnectSessions(const std::vector<SessionId>& sessions,
                                          const std::vector<SessionLink>& links);

}  // namespace rovio_sfm
