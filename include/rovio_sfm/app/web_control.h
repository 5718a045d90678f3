#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace rovio_sfm {

// What the buttons of the live page ask of mapping: its services of the same names.
struct FinishSessionOrder {
  std::string robot;
};
struct MergeSessionsOrder {
  uint32_t session_a = 0, session_b = 0;
  bool force = false;
};
struct UnmergeSessionOrder {
  uint32_t session = 0;
};
struct SaveMapOrder {
  std::string name;
  bool overwrite = false;
};
using ControlOrder =
    std::variant<FinishSessionOrder, MergeSessionsOrder, UnmergeSessionOrder, SaveMapOrder>;

// The order of a service's name and its fields as a JSON object; nothing where they do not fit, and
// `error` names field, value and expectation.
std::optional<ControlOrder> ParseOrder(const std::string& service, const std::string& json,
                                       std::string* error);

// The services that ParseOrder knows, for a sentence.
std::string OrderNames();

bool IsOrder(const std::string& service);

}  // namespace rovio_sfm
