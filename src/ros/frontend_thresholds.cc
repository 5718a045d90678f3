#include "rovio_sfm/ros/frontend_thresholds.h"

#include <dynamic_reconfigure/config_tools.h>

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace rovio_sfm {
namespace {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigTools;

// Shows a function the thresholds alone.
class LiveTable : public OptionTable {
 public:
  using Show = std::function<void(const std::string& name, const OptionRow& row, OptionValue)>;

  explicit LiveTable(Show show) : show_(std::move(show)) {}

 private:
  void VisitOption(const OptionRow& row, OptionValue value) override {
    if (row.use == OptionUse::kLive) show_(prefixes_.back() + row.name, row, value);
  }
  void BeginGroup(const char* name, const char* /*reason*/) override {
    prefixes_.push_back(prefixes_.back() + name + "_");
  }
  void EndGroup() override { prefixes_.pop_back(); }

  Show show_;
  std::vector<std::string> prefixes_ = {""};
};

void ShowThresholds(FrontendOptions* options, const LiveTable::Show& show) {
  LiveTable table(show);
  options->DescribeOptions(table);
}

// Calls visit(Type, name, row, field) where Type, a value, is what dynamic_reconfigure has for the
// field: bool, int or double.
template <typename Visit>
void VisitThresholds(FrontendOptions* options, const Visit& visit) {
  ShowThresholds(options, [&](const std::string& name, const OptionRow& row, OptionValue value) {
    if (auto** flag = std::get_if<bool*>(&value)) visit(bool(), name, row, *flag);
    if (auto** count = std::get_if<int*>(&value)) visit(int(), name, row, *count);
    if (auto** number = std::get_if<float*>(&value)) visit(double(), name, row, *number);
    if (auto** number = std::get_if<double*>(&value)) visit(double(), name, row, *number);
  });
}

template <typename Field>
void SetBound(Field* field, double bound, bool is_high) {
  if constexpr (std::is_same_v<Field, bool>) {
    *field = is_high;
  } else {
    *field = static_cast<Field>(bound);
  }
}

const char* NameOf(bool) { return "bool"; }
const char* NameOf(int) { return "int"; }
const char* NameOf(double) { return "double"; }

}  // namespace

FrontendThresholdsConfig FrontendThresholdsConfig::__getMin__() {
  FrontendThresholdsConfig lowest;
  VisitThresholds(&lowest.options_, [](auto, const std::string&, const OptionRow& row,
                                       auto* field) { SetBound(field, row.low, false); });
  return lowest;
}

FrontendThresholdsConfig FrontendThresholdsConfig::__getMax__() {
  FrontendThresholdsConfig highest;
  VisitThresholds(&highest.options_, [](auto, const std::string&, const OptionRow& row,
                                        auto* field) { SetBound(field, row.high, true); });
  return highest;
}

dynamic_reconfigure::ConfigDescription FrontendThresholdsConfig::__getDescriptionMessage__() {
  dynamic_reconfigure::ConfigDescription description;
  __getMin__().__toMessage__(description.min);
  __getMax__().__toMessage__(description.max);
  __getDefault__().__toMessage__(description.dflt);
  description.groups.resize(1);
  description.groups[0].name = "Default";
  FrontendOptions options;
  VisitThresholds(&options, [&](auto type, const std::string& name, const OptionRow& row, auto*) {
    dynamic_reconfigure::ParamDescription parameter;
    parameter.name = name;
    parameter.type = NameOf(type);
    parameter.description = row.reason;
    description.groups[0].parameters.push_back(parameter);
  });
  return description;
}

void FrontendThresholdsConfig::__toMessage__(Config& message) const {
  message = Config();
  message.groups.resize(1);
  message.groups[0].name = "Default";
  message.groups[0].state = true;
  FrontendOptions options = options_;
  VisitThresholds(
      &options, [&](auto type, const std::string& name, const OptionRow&, const auto* field) {
        ConfigTools::appendParameter(message, name, static_cast<decltype(type)>(*field));
      });
}

void FrontendThresholdsConfig::__fromMessage__(const Config& message) {
  VisitThresholds(&options_,
                  [&](auto value, const std::string& name, const OptionRow&, auto* field) {
                    if (ConfigTools::getParameter(message, name, value)) {
                      *field = static_cast<std::remove_pointer_t<decltype(field)>>(value);
                    }
                  });
}

void FrontendThresholdsConfig::__toServer__(const ros::NodeHandle& node) const {
  FrontendOptions options = options_;
  VisitThresholds(&options,
                  [&](auto type, const std::string& name, const OptionRow&, const auto* field) {
                    node.setParam(name, static_cast<decltype(type)>(*field));
                  });
}

void FrontendThresholdsConfig::__fromServer__(const ros::NodeHandle& node) {
  VisitThresholds(&options_,
                  [&](auto value, const std::string& name, const OptionRow&, auto* field) {
                    if (node.getParam(name, value)) {
                      *field = static_cast<std::remove_pointer_t<decltype(field)>>(value);
                    }
                  });
}

void FrontendThresholdsConfig::__clamp__() {
  VisitThresholds(&options_, [](auto, const std::string&, const OptionRow& row, auto* field) {
    using Field = std::remove_pointer_t<decltype(field)>;
    if constexpr (!std::is_same_v<Field, bool>) {
      *field = std::clamp(*field, static_cast<Field>(row.low), static_cast<Field>(row.high));
    }
  });
}

FrontendOptions WithThresholds(const FrontendOptions& options,
                               const FrontendThresholdsConfig& thresholds) {
  Config message;
  thresholds.__toMessage__(message);
  FrontendThresholdsConfig changed(options);
  changed.__fromMessage__(message);
  return changed.options_;
}

}  // namespace rovio_sfm
