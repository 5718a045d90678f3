#pragma once

#include <rovio_sfm/MergeReportMsg.h>

#include <vector>

#include "rovio_sfm/scene/merge_report.h"

namespace rovio_sfm {

MergeReportMsg ToMessage(const MergeReport& report);
std::vector<MergeReportMsg> ToMessages(const std::vector<MergeReport>& reports);

}  // namespace rovio_sfm
