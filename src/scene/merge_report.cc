#include "rovio_sfm/scene/merge_report.h"

#include <tuple>

namespace rovio_sfm {
namespace {

auto FieldsOf(const MergeReport& r) {
  return std::tie(r.id, r.kind, r.verdict, r.accepted_by, r.reason, r.warning, r.query, r.other,
                  r.query_session, r.other_session, r.num_candidates, r.num_matches, r.num_inliers,
                  r.num_common, r.by_resection, r.query_from_other, r.sigma_log_scale,
                  r.num_expected, r.num_found, r.num_links, r.error_before_px, r.error_after_px);
}

}  // namespace

bool operator==(const MergeReport& a, const MergeReport& b) { return FieldsOf(a) == FieldsOf(b); }

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

const char* ToString(AcceptedBy by) {
  switch (by) {
    case AcceptedBy::kNobody:
      return "nobody";
    case AcceptedBy::kEvidence:
      return "evidence";
    case AcceptedBy::kSecondOverlap:
      return "second overlap";
    case AcceptedBy::kRequest:
      return "request";
    case AcceptedBy::kHand:
      return "hand";
  }
  return "unknown";
}

}  // namespace rovio_sfm
