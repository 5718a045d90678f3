#include "rovio_sfm/util/check_options.h"

#include <algorithm>
#include <type_traits>

#include "rovio_sfm/util/option_text.h"

namespace rovio_sfm {
namespace {

template <typename Number>
bool IsWithin(const OptionRow& row, Number value) {
  using Bound = std::conditional_t<std::is_same_v<Number, float>, float, double>;
  const auto compared = static_cast<Bound>(value);
  return compared >= static_cast<Bound>(row.low) && compared <= static_cast<Bound>(row.high);
}

bool IsWithin(const OptionRow&, bool) { return true; }

bool IsWithin(const OptionRow& row, const std::string& value) {
  return row.choices.empty() ||
         std::find(row.choices.begin(), row.choices.end(), value) != row.choices.end();
}

template <typename Item>
bool IsWithin(const OptionRow& row, const std::vector<Item>& values) {
  return std::all_of(values.begin(), values.end(),
                     [&](const Item& value) { return IsWithin(row, value); });
}

}  // namespace

CheckTable::CheckTable(const std::string& group) : groups_{group.empty() ? "" : group + "."} {}

void CheckTable::VisitOption(const OptionRow& row, OptionValue value) {
  texts_[groups_.back() + row.name] = TextOf(value);
  const bool fits = std::visit([&](const auto* field) { return IsWithin(row, *field); }, value);
  if (!fits) ComplainAbout(row.name, RangeText(row));
}

void CheckTable::VisitRule(const char* name, bool holds, const char* expected) {
  if (!holds) ComplainAbout(name, expected);
}

void CheckTable::BeginGroup(const char* name, const char* /*reason*/) {
  groups_.push_back(groups_.back() + name + ".");
}

void CheckTable::EndGroup() { groups_.pop_back(); }

void CheckTable::ComplainAbout(const std::string& name, const std::string& expected) {
  const std::string path = groups_.back() + name;
  if (complaint_.empty()) complaint_ = path + " = " + texts_[path] + ": expected " + expected;
}

}  // namespace rovio_sfm
