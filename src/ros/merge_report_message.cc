#include "rovio_sfm/ros/merge_report_message.h"

#include <cmath>

#include "rovio_sfm/ros/conversions.h"

namespace rovio_sfm {

MergeReportMsg ToMessage(const MergeReport& report) {
  MergeReportMsg message;
  message.id = report.id;
  message.kind = static_cast<uint8_t>(report.kind);
  message.verdict = static_cast<uint8_t>(report.verdict);
  message.accepted_by = static_cast<uint8_t>(report.accepted_by);
  message.reason = report.reason;
  message.warning = report.warning;
  message.query = ToMessage(report.query);
  message.other = ToMessage(report.other);
  message.query_session = report.query_session.value;
  message.other_session = report.other_session.value;
  message.num_candidates = report.num_candidates;
  message.num_matches = report.num_matches;
  message.num_inliers = report.num_inliers;
  message.num_common = report.num_common;
  message.by_resection = report.by_resection;
  message.query_from_other =
      ToTransform(Rigid3{report.query_from_other.rotation, report.query_from_other.translation});
  message.scale = report.query_from_other.scale;
  message.sigma_log_scale = report.sigma_log_scale;
  message.num_expected = report.num_expected;
  message.num_found = report.num_found;
  message.num_links = report.num_links;
  message.error_before_px = report.error_before_px;
  message.error_after_px = report.error_after_px.value_or(std::nan(""));
  return message;
}

std::vector<MergeReportMsg> ToMessages(const std::vector<MergeReport>& reports) {
  std::vector<MergeReportMsg> messages;
  for (const MergeReport& report : reports) messages.push_back(ToMessage(report));
  return messages;
}

}  // namespace rovio_sfm
