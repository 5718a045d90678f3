#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rovio_sfm {

// kLive: may change while the node runs. kRequired: has no default that works.
enum class OptionUse { kAtStart, kLive, kRequired };

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// How one option is said. Its unit is the end of its name: _px, _rad, _deg, _s, _m and so on.
struct OptionRow {
  const char* name;
  const char* reason;
  OptionUse use = OptionUse::kAtStart;
  double low = -kNoLimit, high = kNoLimit;  // of a number, or of each of a list; bounds allowed
  std::vector<std::string> choices = {};    // of a text; empty: any
};

using OptionValue =
    std::variant<bool*, int*, uint64_t*, float*, double*, std::string*, std::vector<int>*,
                 std::vector<double>*, std::vector<std::string>*>;

// What walks the options of a struct to check, load, show or document them. The struct's
// `void DescribeOptions(OptionTable&)` calls one Add… per field, its only description; a table may
// change the values that it sees: so options are loaded.
class OptionTable {
 public:
  virtual ~OptionTable() = default;

  // low <= value <= high; NaN never fits.
  template <typename Number>
  void AddNumber(const char* name, Number& value, double low, double high, const char* reason) {
    VisitOption({name, reason, OptionUse::kAtStart, low, high}, &value);
  }
  template <typename Number>
  void AddLiveNumber(const char* name, Number& value, double low, double high, const char* reason) {
    VisitOption({name, reason, OptionUse::kLive, low, high}, &value);
  }

  // An angle in radians, said in degrees.
  void AddDegrees(const char* name, double& value_rad, double low_deg, double high_deg,
                  const char* reason) {
    AddConverted(name, value_rad, M_PI, 180.0, low_deg, high_deg, reason);
  }

  // A time in nanoseconds, said in seconds.
  void AddSeconds(const char* name, int64_t& value_ns, double low_s, double high_s,
                  const char* reason) {
    auto ns = static_cast<double>(value_ns);
    AddConverted(name, ns, 1e9, 1.0, low_s, high_s, reason);
    value_ns = std::llround(ns);
  }

  // A list of as many numbers as the field holds.
  template <typename Number, size_t kSize>
  void AddNumbers(const char* name, std::array<Number, kSize>& values, double low, double high,
                  const char* reason) {
    std::vector<Number> list(values.begin(), values.end());
    VisitOption({name, reason, OptionUse::kAtStart, low, high}, &list);
    if (list.size() == kSize) std::copy(list.begin(), list.end(), values.begin());
  }

  void AddFlag(const char* name, bool& value, const char* reason) {
    VisitOption({name, reason}, &value);
  }
  void AddLiveFlag(const char* name, bool& value, const char* reason) {
    VisitOption({name, reason, OptionUse::kLive}, &value);
  }

  void AddText(const char* name, std::string& value, const char* reason,
               OptionUse use = OptionUse::kAtStart) {
    VisitOption({name, reason, use}, &value);
  }

  void AddTexts(const char* name, std::vector<std::string>& values, const char* reason) {
    VisitOption({name, reason}, &values);
  }

  // An enumerator, said by its name.
  template <typename Enum>
  void AddChoice(const char* name, Enum& value,
                 const std::vector<std::pair<const char*, Enum>>& choices, const char* reason);

  // A struct inside; its options stand under the group's name.
  template <typename Options>
  void AddGroup(const char* name, Options& options, const char* reason) {
    BeginGroup(name, reason);
    options.DescribeOptions(*this);
    EndGroup();
  }

  // What the option of that name, said before, must fulfil beside its range; expected follows
  // "expected": "at most max_features".
  void AddRule(const char* name, bool holds, const char* expected) {
    VisitRule(name, holds, expected);
  }

 private:
  virtual void VisitOption(const OptionRow& row, OptionValue value) = 0;
  virtual void VisitRule(const char* /*name*/, bool /*holds*/, const char* /*expected*/) {}
  virtual void BeginGroup(const char* /*name*/, const char* /*reason*/) {}
  virtual void EndGroup() {}

  // value = shown * factor / divisor; shown without what the conversion blurs. A value that is not
  // changed keeps its bits.
  void AddConverted(const char* name, double& value, double factor, double divisor, double low,
                    double high, const char* reason) {
    const double shown = std::round(value * divisor / factor * 1e9) / 1e9;
    double changed = shown;
    VisitOption({name, reason, OptionUse::kAtStart, low, high}, &changed);
    if (changed != shown) value = changed * factor / divisor;
  }
};

template <typename Enum>
void OptionTable::AddChoice(const char* name, Enum& value,
                            const std::vector<std::pair<const char*, Enum>>& choices,
                            const char* reason) {
  OptionRow row{name, reason};
  std::string chosen;
  for (const auto& [choice, enumerator] : choices) {
    row.choices.emplace_back(choice);
    if (enumerator == value) chosen = choice;
  }
  VisitOption(row, &chosen);
  for (const auto& [choice, enumerator] : choices) {
    if (choice == chosen) value = enumerator;
  }
}

}  // namespace rovio_sfm
