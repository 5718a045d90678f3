#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <ros/node_handle.h>

#include <cstdint>

#include "rovio_sfm/frontend/frontend_options.h"

namespace rovio_sfm {

// The options of the frontend that may change while it runs (OptionUse::kLive), as
// dynamic_reconfigure::Server<ConfigType> wants them: that is where the names come from. A
// threshold is named by its option's path with _ between the parts.
class FrontendThresholdsConfig {
 public:
  FrontendThresholdsConfig() = default;
  explicit FrontendThresholdsConfig(const FrontendOptions& options) : options_(options) {}

  // NOLINTBEGIN(bugprone-reserved-identifier)
  static FrontendThresholdsConfig __getDefault__() { return {}; }
  static FrontendThresholdsConfig __getMin__();
  static FrontendThresholdsConfig __getMax__();
  static dynamic_reconfigure::ConfigDescription __getDescriptionMessage__();
  static int __getParamDescriptions__() { return 0; }  // handed back to __toMessage__
  static int __getGroupDescriptions__() { return 0; }

  void __toMessage__(dynamic_reconfigure::Config& message) const;
  void __toMessage__(dynamic_reconfigure::Config& message, int, int) const {
    __toMessage__(message);
  }
  // What the message does not name stays.
  void __fromMessage__(const dynamic_reconfigure::Config& message);
  void __toServer__(const ros::NodeHandle& node) const;
  void __fromServer__(const ros::NodeHandle& node);
  void __clamp__();
  uint32_t __level__(const FrontendThresholdsConfig&) const { return 0; }
  // NOLINTEND(bugprone-reserved-identifier)

 private:
  FrontendOptions options_;  // the thresholds of these

  friend FrontendOptions WithThresholds(const FrontendOptions& options,
                                        const FrontendThresholdsConfig& thresholds);
};

// The options with these thresholds; the rest stays. Not checked.
FrontendOptions WithThresholds(const FrontendOptions& options,
                               const FrontendThresholdsConfig& thresholds);

}  // namespace rovio_sfm
