#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/scene/drive_state.h"
#include "rovio_sfm/scene/merge_edit.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session_record.h"

namespace rovio_sfm {

// What is known of how sessions lie to one another.
struct MergeRecord {
  std::vector<MergeEdit> edits;                         // by id
  uint32_t num_accepted = 0;                            // so far, undone ones too
  std::map<MapId, uint32_t> revisions;                  // of the maps' gauges
  std::set<std::pair<SessionId, SessionId>> separated;  // by request; smaller id first
  std::vector<PlaceMatch> waiting;                      // in the order in which they came
};

// All maps of a store, as they are kept on disk.
struct MapRecord {
  std::vector<DriveRecord> drives;  // in the order in which they came
  std::vector<SessionRecord> sessions;
  MergeRecord merges;
};

}  // namespace rovio_sfm
