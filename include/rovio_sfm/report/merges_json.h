#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "rovio_sfm/scene/merge_report.h"

namespace rovio_sfm {

// How many overlaps were accepted, provisional, refused, undone, and every report.
nlohmann::ordered_json MergesJson(const std::vector<MergeReport>& reports);

}  // namespace rovio_sfm
