#pragma once

#include <cstdint>
#include <map>

#include "rovio_sfm/scene/link_list.h"
#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/scene/place_match.h"

namespace rovio_sfm {

// An overlap that was judged. The accepted ones are what the maps are made of (design 4: merges are
// a list of edits); undoing takes some out and makes the others again as they were accepted.
struct MergeEdit {
  MergeReport report;
  PlaceMatch match;                     // no pairs where it was placed by hand
  LinkList links;                       // sorted
  uint32_t sequence = 0;                // counts acceptances, from 1
  std::map<SessionId, uint32_t> marks;  // of the sessions' journals, just before it joined two maps

  bool IsAccepted() const { return report.verdict == MergeVerdict::kAccepted; }
  bool IsMerge() const { return IsAccepted() && report.kind != MergeKind::kLoop; }
};

}  // namespace rovio_sfm
