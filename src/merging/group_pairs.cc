#include "rovio_sfm/merging/group_pairs.h"

namespace rovio_sfm {

PairsBySession GroupPairs(const PlaceMatch& match, const SessionTable& sessions) {
  PairsBySession pairs;
  for (const OverlapPair& pair : match.pairs) {
    const Session* session = sessions.FindHolder(pair.other);
    if (session != nullptr) pairs[session->id()].push_back(pair);
  }
  return pairs;
}

SessionId FindRichest(const PairsBySession& pairs) {
  SessionId richest;
  size_t most = 0;
  for (const auto& [id, list] : pairs) {
    size_t count = 1;
    for (const OverlapPair& pair : list) count += pair.inliers.size();
    if (count <= most) continue;
    richest = id;
    most = count;
  }
  return richest;
}

}  // namespace rovio_sfm
