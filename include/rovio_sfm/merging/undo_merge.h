#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/merging/merge_list.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// What taking a session out of its map means for the list (design 5.4).
struct UndoPlan {
  std::vector<MergeEdit*> undone;       // accepted edits that the session shares with another one
  std::vector<MergeEdit*> repeated;     // edits of others that came since, in order of acceptance
  std::map<SessionId, uint32_t> marks;  // to which each session that they touched goes back
};

UndoPlan PlanUndo(SessionId id, MergeList* list);

// Gives a session back its frames and landmarks of a mark, to the byte. Frames that came since keep
// their own tracks and landmarks, moved by the similarity over what both states share, and are
// resected there. Where nothing is shared they are resected alone, else they are weak.
void RestoreSession(uint32_t mark, const MapperOptions& options, Session* session);

}  // namespace rovio_sfm
