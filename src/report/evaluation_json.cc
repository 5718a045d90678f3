#include "rovio_sfm/report/evaluation_json.h"

#include <nlohmann/json.hpp>

namespace rovio_sfm {
namespace {

nlohmann::ordered_json OrNull(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

nlohmann::ordered_json EvaluationJson(const EvaluationReport& report, bool metric) {
  nlohmann::ordered_json json;
  json["poses"] = report.num_poses;
  json["compared"] = report.num_compared;
  json["path_length_m"] = report.path_length_m;
  json["ate_rmse_m"] = report.ate_rmse_m;
  json["ate_p95_m"] = report.ate_p95_m;
  json["ate_max_m"] = report.ate_max_m;
  json["rotation_rmse_deg"] = report.rotation_rmse_deg;
  json["roll_deg"] = report.roll_deg;
  json["rotation_rmse_after_roll_deg"] = report.rotation_rmse_after_roll_deg;
  json["rpe_pairs"] = report.num_rpe_pairs;
  json["rpe_rmse_m"] = OrNull(report.rpe_rmse_m);
  json["rpe_rotation_rmse_deg"] = OrNull(report.rpe_rotation_rmse_deg);
  json["scale"] = report.world_from_map.scale;
  json["scale_error"] = OrNull(metric ? std::optional<double>(report.scale_error) : std::nullopt);
  return json;
}

}  // namespace rovio_sfm
