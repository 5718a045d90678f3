#include "rovio_sfm/scene/merge_report.h"

namespace rovio_sfm {

const char* ToString(MergeKind kind) {
  switch (kind) {
    case MergeKind::kMerge:
      return "merge";
    case MergeKind::kLoop:
      return "loop";
    case MergeKind::kSeed:
      return "seed";
  }
  return "unknown";
}

const char* ToString(MergeVerdict verdict) {
  switch (verdict) {
    case MergeVerdict::kWaiting:
      return "waiting";
    case MergeVerdict::kAccepted:
      return "accepted";
    case MergeVerdict::kProvisional:
      return "provisional";
    case MergeVerdict::kRefused:
      return "refused";
    case MergeVerdict::kUndone:
      return "undone";
  }
  return "unknown";
}

}  // namespace rovio_sfm
