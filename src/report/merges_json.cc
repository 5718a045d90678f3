#include "rovio_sfm/report/merges_json.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace rovio_sfm {
namespace {

using Json = nlohmann::ordered_json;

Json ReportJson(const MergeReport& report) {
  return {{"id", report.id},
          {"kind", ToString(report.kind)},
          {"verdict", ToString(report.verdict)},
          {"accepted_by", ToString(report.accepted_by)},
          {"reason", report.reason},
          {"warning", report.warning},
          {"query", report.query.ToString()},
          {"other", report.other.ToString()},
          {"query_session", report.query_session.value},
          {"other_session", report.other_session.value},
          {"candidates", report.num_candidates},
          {"matches", report.num_matches},
          {"inliers", report.num_inliers},
          {"common_landmarks", report.num_common},
          {"by_resection", report.by_resection},
          {"scale_query_from_other", report.query_from_other.scale},
          {"sigma_log_scale", report.sigma_log_scale},
          {"expected_landmarks", report.num_expected},
          {"found_landmarks", report.num_found},
          {"links", report.num_links},
          {"error_before_px", report.error_before_px},
          {"error_after_px",
           report.error_after_px ? nlohmann::ordered_json(*report.error_after_px) : nullptr}};
}

}  // namespace

Json MergesJson(const std::vector<MergeReport>& reports) {
  std::map<std::string, size_t> counts = {
      {"accepted", 0}, {"provisional", 0}, {"refused", 0}, {"undone", 0}};
  Json list = Json::array();
  for (const MergeReport& report : reports) {
    ++counts[ToString(report.verdict)];
    list.push_back(ReportJson(report));
  }
  Json json = counts;
  json["reports"] = list;
  return json;
}

}  // namespace rovio_sfm
