#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// What an overlap joins.
enum class MergeKind : uint8_t {
  kMerge = 0,  // two maps become one
  kLoop = 1,   // two frames of one map (§4.5): links and adjustment, no pose anew
  kSeed = 2,   // a session without a map goes on in another's (§4.3.2)
};

enum class MergeVerdict : uint8_t {
  kWaiting = 0,      // for frames, or for a session to grow
  kAccepted = 1,     // adjusted
  kProvisional = 2,  // shown, not adjusted: waits for a second, independent overlap
  kRefused = 3,
  kUndone = 4,
};

// Who took an edit into the map.
enum class AcceptedBy : uint8_t {
  kNobody = 0,
  kEvidence = 1,       // its own
  kSecondOverlap = 2,  // another one that says the same
  kRequest = 3,        // merge_sessions
  kHand = 4,           // placed by the caller, without any overlap
};
const char* ToString(MergeKind kind);
const char* ToString(MergeVerdict verdict);
const char* ToString(AcceptedBy by);

// What became of one overlap, and why (§4.3, design 5.4).
struct MergeReport {
  uint32_t id = 0;  // counted from 1; 0 for none
  MergeKind kind = MergeKind::kMerge;
  MergeVerdict verdict = MergeVerdict::kWaiting;
  AcceptedBy accepted_by = AcceptedBy::kNobody;
  std::string reason;   // one sentence for people
  std::string warning;  // empty if there is none
  FrameId query, other;
  SessionId query_session, other_session;
  uint32_t num_candidates = 0;  // pairs of frames matched around the overlap
  uint32_t num_matches = 0;     // verified matches of features in them
  uint32_t num_inliers = 0;     // of them, of the alignment
  uint32_t num_common = 0;      // distinct landmarks that both sessions have
  bool by_resection = false;    // 2D-3D instead of 3D-3D
  Sim3 query_from_other;        // between the gauges of the two sessions
  double sigma_log_scale = 0.0;
  uint32_t num_expected = 0;  // landmarks of the other session that should be visible in the query
  uint32_t num_found = 0;     // of them found
  uint32_t num_links = 0;     // features joined, after the guided search
  // Median error of landmarks seen across: before the adjustment, and once its result was applied.
  double error_before_px = 0.0;
  std::optional<double> error_after_px;
};
bool operator==(const MergeReport& a, const MergeReport& b);

}  // namespace rovio_sfm
