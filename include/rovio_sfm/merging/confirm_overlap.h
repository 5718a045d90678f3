#pragma once

#include "rovio_sfm/merging/loop_gap.h"
#include "rovio_sfm/merging/merge_list.h"
#include "rovio_sfm/merging/merge_options.h"

namespace rovio_sfm {

// True where the gap is within the options' bounds of scale and rotation.
bool IsSmall(const LoopGap& gap, const MergeOptions& options);

// How far an overlap between two sessions of one map is from what the map says, at its query frame;
// `way`: the camera's way between the two frames, or of both sessions, in the query's session.
struct LoopStatement {
  LoopGap gap;
  double way = 0.0;
};
LoopStatement MeasureLoop(const MergeReport& report, const MergeList& list,
                          const SessionTable& sessions);

// A provisional overlap of the list between the same two maps that says what the edit says, by
// other landmarks (design 5.4: a second, independent overlap confirms the first). Null if none.
MergeEdit* FindConfirmation(const MergeEdit& edit, const MergeOptions& options,
                            const SessionTable& sessions, MergeList* list);

}  // namespace rovio_sfm
