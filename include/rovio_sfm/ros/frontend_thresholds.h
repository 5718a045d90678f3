#pragma once

#include "rovio_sfm/FrontendThresholdsConfig.h"
#include "rovio_sfm/frontend/frontend_options.h"

namespace rovio_sfm {

// What dynamic_reconfigure shows of the options (cfg/FrontendThresholds.cfg).
FrontendThresholdsConfig ThresholdsOf(const FrontendOptions& options);

// The options with these thresholds; the rest stays. Not checked.
FrontendOptions WithThresholds(FrontendOptions options, const FrontendThresholdsConfig& thresholds);

}  // namespace rovio_sfm
