#include "rovio_sfm/util/option_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace rovio_sfm {
namespace {

std::string FormatNumber(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

// The fewest digits, six or more, that read back as the same Number; whole ones without exponent.
template <typename Number>
std::string ShortestText(Number value) {
  const auto wide = static_cast<double>(value);
  std::string text = FormatNumber(wide, 15);
  if (wide == std::floor(wide) && std::abs(wide) < 1e15) return text;
  for (int digits = 6; digits <= 17; ++digits) {
    text = FormatNumber(wide, digits);
    if (static_cast<Number>(std::strtod(text.c_str(), nullptr)) == value) break;
  }
  return text;
}

std::string TextOfItem(bool value) { return value ? "true" : "false"; }
std::string TextOfItem(int value) { return std::to_string(value); }
std::string TextOfItem(uint64_t value) { return std::to_string(value); }
std::string TextOfItem(float value) { return ShortestText(value); }
std::string TextOfItem(double value) { return ShortestText(value); }
std::string TextOfItem(const std::string& value) { return value; }

std::string YamlTextOfItem(bool value) { return TextOfItem(value); }
std::string YamlTextOfItem(int value) { return TextOfItem(value); }
std::string YamlTextOfItem(uint64_t value) { return TextOfItem(value); }

// YAML 1.1 takes 1e-05 for a text: a number needs its point.
template <typename Number>
std::string YamlTextOfItem(Number value) {
  std::string text = TextOfItem(value);
  if (text.find('.') != std::string::npos) return text;
  return text.insert(std::min(text.find('e'), text.size()), ".0");
}

std::string YamlTextOfItem(const std::string& value) {
  const bool is_plain = !value.empty() && value.find_first_of("\"'#[]{}, ") == std::string::npos;
  return is_plain ? value : '"' + value + '"';
}

template <typename Values, typename Text>
std::string ListText(const Values& values, const Text& text_of) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + text_of(value);
  return "[" + text + "]";
}

template <typename Value, typename Text>
std::string TextOfAny(const Value& value, const Text& text_of) {
  return text_of(value);
}

template <typename Value, typename Text>
std::string TextOfAny(const std::vector<Value>& values, const Text& text_of) {
  return ListText(values, text_of);
}

}  // namespace

std::string TextOf(const OptionValue& value) {
  const auto text_of = [](const auto& item) { return TextOfItem(item); };
  return std::visit([&](const auto* field) { return TextOfAny(*field, text_of); }, value);
}

std::string TextOf(double value) { return TextOfItem(value); }

std::string YamlTextOf(const OptionValue& value) {
  const auto text_of = [](const auto& item) { return YamlTextOfItem(item); };
  return std::visit([&](const auto* field) { return TextOfAny(*field, text_of); }, value);
}

std::string RangeText(const OptionRow& row) {
  std::string text;
  for (size_t i = 0; i < row.choices.size(); ++i) {
    const bool is_last = i + 1 == row.choices.size();
    text += (i == 0 ? "" : is_last ? " or " : ", ") + row.choices[i];
  }
  if (row.low == -kNoLimit) return text;
  if (row.high == kNoLimit) return TextOf(row.low) + " or more";
  return TextOf(row.low) + " to " + TextOf(row.high);
}

std::string UnitOf(const std::string& name) {
  static const std::vector<std::pair<std::string, std::string>> kUnits = {
      {"_rad_per_sqrt_rad", "rad/√rad"},
      {"_rad_per_sqrt_m", "rad/√m"},
      {"_m_per_sqrt_m", "m/√m"},
      {"_m_per_s", "m/s"},
      {"_rad_per_s", "rad/s"},
      {"_bytes_per_s", "bytes/s"},
      {"_per_m", "1/m"},
      {"_px", "px"},
      {"_rad", "rad"},
      {"_deg", "°"},
      {"_s", "s"},
      {"_m", "m"},
      {"_hz", "Hz"},
      {"_mb", "MiB"},
      {"_bytes", "bytes"},
      {"_sigmas", "σ"}};
  for (const auto& [ending, unit] : kUnits) {
    if (name.size() < ending.size()) continue;
    if (name.compare(name.size() - ending.size(), ending.size(), ending) == 0) return unit;
  }
  return "";
}

}  // namespace rovio_sfm
