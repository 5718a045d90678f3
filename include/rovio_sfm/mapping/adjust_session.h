#pragma once

#include <cstdint>
#include <future>
#include <optional>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/prune_landmarks.h"
#include "rovio_sfm/sfm/session_bundle.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {

// Adjusts the frame and its most covisible neighbours, the others that see their landmarks fixed,
// and prunes those landmarks (§3.8.2, local scope). Returns what was pruned.
PruneReport AdjustLocally(uint32_t frame, const MapperOptions& options, Session* session);

// Adjusts everything, prunes, and completes tracks until little changes: the end of a session. The
// last pass minimises the squared error of what is left.
PruneReport AdjustFinally(const MapperOptions& options, Session* session);

// Adjusts all frames and landmarks beside the main flow, on a copy: started after one keyframe,
// brought back a fixed number of keyframes later, whatever the threads do meanwhile.
class GlobalAdjustment {
 public:
  // The executor must outlive this.
  GlobalAdjustment(const MapperOptions& options, Executor* executor);

  // Starts one if none is running and the session grew enough since the last.
  void MaybeStart(const Session& session);
  // Counts a keyframe; applies the result when it is due. True if something was applied.
  bool Advance(Session* session);
  // Waits for a running one and forgets it: of a session that ended.
  void Abandon();

 private:
  struct Running {
    std::future<SessionBundle> result;
    int num_keyframes_since;  // clang 14 takes no initializer here
  };

  AdjustOptions options_;
  double loss_sigmas_;
  Executor* executor_;
  std::optional<Running> running_;
  size_t num_frames_at_last_ = 0;
  size_t num_landmarks_at_last_ = 0;
};

}  // namespace rovio_sfm
