#include "rovio_sfm/util/yaml_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/util/load_document.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxShown = 40;  // characters

template <typename T>
bool IsSound(const T& /*value*/) {
  return true;
}

template <typename T>
bool IsWritten(const YAML::Node& /*node*/, const T& /*value*/) {
  return true;
}

bool IsWritten(const YAML::Node& node, int /*value*/) { return IsDecimal(node.Scalar()); }
bool IsWritten(const YAML::Node& node, uint32_t /*value*/) { return IsDecimal(node.Scalar()); }
bool IsWritten(const YAML::Node& node, uint64_t /*value*/) { return IsDecimal(node.Scalar()); }
bool IsWritten(const YAML::Node& node, const std::vector<int>& /*values*/) {
  return std::all_of(node.begin(), node.end(),
                     [](const YAML::Node& item) { return IsDecimal(item.Scalar()); });
}

// For messages.
std::string TextOf(const YAML::Node& node) {
  if (node.IsNull()) return "nothing";
  if (node.IsSequence()) return "a list";
  if (node.IsMap()) return "a mapping";
  const std::string& text = node.Scalar();
  return "'" + (text.size() > kMaxShown ? text.substr(0, kMaxShown) + "…" : text) + "'";
}

bool IsSound(double value) { return std::isfinite(value); }
bool IsSound(float value) { return std::isfinite(value); }
bool IsSound(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return IsSound(value); });
}

}  // namespace

YamlMap::YamlMap(const YAML::Node& node, std::string where, std::string separator)
    : where_(std::move(where)), separator_(std::move(separator)) {
  if (!node.IsDefined() || node.IsNull()) return;
  const std::string whole = where_.empty() ? "" : where_ + ": ";
  if (!node.IsMap()) throw std::runtime_error(whole + "expected a mapping");
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) throw std::runtime_error(whole + "expected plain keys");
    const std::string& key = entry.first.Scalar();
    if (!entries_.emplace(key, entry.second).second) Fail(key, "stands twice");
  }
}

YAML::Node YamlMap::Get(const std::string& key) {
  if (!Has(key)) Fail(key, "missing");
  used_.insert(key);
  return entries_.at(key);
}

std::string YamlMap::PathOf(const std::string& key) const {
  return where_.empty() ? key : where_ + separator_ + key;
}

void YamlMap::Fail(const std::string& key, const std::string& reason) const {
  throw std::runtime_error(PathOf(key) + ": " + reason);
}

template <typename T>
void YamlMap::Read(const std::string& key, const std::string& expected, T* value) {
  used_.insert(key);
  if (!Has(key)) return;
  const YAML::Node& node = entries_.at(key);
  const std::string complaint = "expected " + expected + ", not " + TextOf(node);
  try {
    *value = node.as<T>();
  } catch (const YAML::Exception&) {
    Fail(key, complaint);
  }
  if (!IsSound(*value) || !IsWritten(node, *value)) Fail(key, complaint);
}

template void YamlMap::Read(const std::string&, const std::string&, bool*);
template void YamlMap::Read(const std::string&, const std::string&, int*);
template void YamlMap::Read(const std::string&, const std::string&, uint32_t*);
template void YamlMap::Read(const std::string&, const std::string&, uint64_t*);
template void YamlMap::Read(const std::string&, const std::string&, float*);
template void YamlMap::Read(const std::string&, const std::string&, double*);
template void YamlMap::Read(const std::string&, const std::string&, std::string*);
template void YamlMap::Read(const std::string&, const std::string&, std::vector<int>*);
template void YamlMap::Read(const std::string&, const std::string&, std::vector<double>*);
template void YamlMap::Read(const std::string&, const std::string&, std::vector<std::string>*);

double YamlMap::Number(const std::string& key) {
  Get(key);
  return Number(key, 0.0);
}

double YamlMap::Number(const std::string& key, double fallback) {
  Read(key, "a number", &fallback);
  return fallback;
}

int YamlMap::Integer(const std::string& key, int fallback) {
  Read(key, "a whole number", &fallback);
  return fallback;
}

uint64_t YamlMap::Seed(const std::string& key, uint64_t fallback) {
  Read(key, "a whole number, 0 or more", &fallback);
  return fallback;
}

std::string YamlMap::Text(const std::string& key) {
  Get(key);
  std::string text;
  Read(key, "text", &text);
  return text;
}

std::vector<double> YamlMap::Numbers(const std::string& key, size_t count) {
  Get(key);
  const std::string expected = std::to_string(count) + " numbers";
  std::vector<double> values;
  Read(key, expected, &values);
  if (values.size() != count) Fail(key, "expected " + expected);
  return values;
}

std::vector<std::string> YamlMap::Texts(const std::string& key) {
  std::vector<std::string> texts;
  Read(key, "a list of texts", &texts);
  return texts;
}

std::vector<YamlMap> YamlMap::List(const std::string& key) {
  if (!Has(key)) return {};
  const YAML::Node node = Get(key);
  if (!node.IsSequence()) Fail(key, "expected a list");
  std::vector<YamlMap> items;
  for (const YAML::Node& item : node) {
    items.emplace_back(item, PathOf(key) + "[" + std::to_string(items.size()) + "]");
  }
  return items;
}

std::vector<std::vector<double>> YamlMap::Rows(const std::string& key, size_t count) {
  const YAML::Node node = Get(key);
  if (!node.IsSequence()) Fail(key, "expected a list of lists");
  std::vector<std::vector<double>> rows;
  for (const YAML::Node& item : node) {
    YAML::Node wrapped;
    wrapped[key] = item;
    rows.push_back(YamlMap(wrapped, where_, separator_).Numbers(key, count));
  }
  return rows;
}

YamlMap YamlMap::Group(const std::string& key) {
  return YamlMap(Has(key) ? Get(key) : YAML::Node(), PathOf(key));
}

void YamlMap::RefuseUnknownKeys() const {
  for (const auto& [key, node] : entries_) {
    if (used_.count(key) == 0) Fail(key, "unknown key");
  }
}

}  // namespace rovio_sfm
