#pragma once

#include <cstdint>
#include <memory>

#include "rovio_sfm/mapping/delayed_result.h"
#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/prune_landmarks.h"
#include "rovio_sfm/sfm/session_bundle.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {

// Adjusts the frame and its most covisible neighbours, the others that see their landmarks fixed,
// and prunes those landmarks (§3.8.2, local scope). Returns what was pruned.
PruneReport AdjustLocally(uint32_t frame, const MapperOptions& options, Session* session);

// What a round of a final adjustment does beside solving: first it makes landmarks of tracks and
// completes them, then it takes away what does not fit.
void CompleteAllTracks(const MapperOptions& options, Session* session);
PruneReport PruneFinally(const MapperOptions& options, Session* session);
// Whether another round is not worth it, by the observations of this one and the one before: some
// are completed and pruned in every round.
bool HasSettled(size_t num_before, size_t num_now);

// How everything is adjusted while drives run.
BundleOptions RunningBundleOptions(const MapperOptions& options);

// How a round of a final adjustment is solved, the last one until nothing changes: a map bends far
// for little cost. It keeps the loss: features of real pictures err by more than a Gaussian even
// after pruning, and few large errors bend a map under squared ones.
BundleOptions FinalBundleOptions(const MapperOptions& options, bool is_last);

// Adjusts everything, prunes, and completes tracks until little changes: the end of a session.
PruneReport AdjustFinally(const MapperOptions& options, Session* session);

// What is known of a session's calibration before its pictures are looked at.
BundleIntrinsics IntrinsicsOf(const AdjustOptions& options, const Session& session);
// Whether so many frames' calibrations are solved for.
bool MayRefine(const AdjustOptions& options, size_t num_frames);

// AdjustFinally, and once more by another calibration of the camera where the pictures tell one
// (RefineIntrinsics). Larger sessions than max_global_frames keep theirs.
PruneReport AdjustWithCamera(const MapperOptions& options, Session* session);

// Adjusts all frames and landmarks beside the main flow, on a copy, and brings the result back.
class GlobalAdjustment {
 public:
  // The executor must outlive this.
  GlobalAdjustment(const MapperOptions& options, Executor* executor, ResultTiming timing);

  // Starts one if none is running and the session grew enough since the last.
  void MaybeStart(const Session& session);
  // Counts a keyframe; applies the result when it is due. True if something was applied.
  bool Advance(Session* session, StageTimes* times = nullptr);
  // Throws away what runs, and begins it again: the session was changed from outside.
  void Restart(const Session& session);
  // Throws away what runs: the session ended.
  void Abandon() { running_.reset(); }

 private:
  void Start(const Session& session);

  AdjustOptions options_;
  BundleOptions bundle_options_;
  Executor* executor_;
  ResultTiming timing_;
  std::unique_ptr<DelayedResult<SessionBundle>> running_;  // null: none
  size_t num_frames_at_last_ = 0;
  size_t num_landmarks_at_last_ = 0;
};

}  // namespace rovio_sfm
