#pragma once

#include <nlohmann/json_fwd.hpp>

#include "rovio_sfm/report/evaluation.h"

namespace rovio_sfm {

// The report with one key per figure, units in the names; scale_error is null unless metric.
nlohmann::ordered_json EvaluationJson(const EvaluationReport& report, bool metric);

}  // namespace rovio_sfm
