#include "rovio_sfm/sim/world/yaml_map.h"

#include <cmath>
#include <stdexcept>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm::sim {
namespace {

template <typename T>
bool Convert(const YAML::Node& node, T* value) {
  return node.IsScalar() && YAML::convert<T>::decode(node, *value);
}

bool ConvertFinite(const YAML::Node& node, double* value) {
  return Convert(node, value) && std::isfinite(*value);
}

}  // namespace

YamlMap::YamlMap(const YAML::Node& node, std::string where) : where_(std::move(where)) {
  if (!node.IsMap()) throw std::runtime_error(where_ + ": expected a mapping");
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) throw std::runtime_error(where_ + ": expected plain keys");
    if (!entries_.emplace(entry.first.Scalar(), entry.second).second) {
      throw std::runtime_error(where_ + ": key " + entry.first.Scalar() + " stands twice");
    }
  }
}

bool YamlMap::Has(const std::string& key) const { return entries_.count(key) == 1; }

YAML::Node YamlMap::Get(const std::string& key) {
  if (!Has(key)) throw std::runtime_error(where_ + ": key " + key + " is missing");
  used_.insert(key);
  return entries_.at(key);
}

void YamlMap::Fail(const std::string& key, const std::string& expected) const {
  throw std::runtime_error(where_ + ": " + key + ": expected " + expected);
}

double YamlMap::Number(const std::string& key) {
  double value = 0.0;
  if (!ConvertFinite(Get(key), &value)) Fail(key, "a number");
  return value;
}

double YamlMap::Number(const std::string& key, double fallback) {
  return Has(key) ? Number(key) : fallback;
}

int YamlMap::Integer(const std::string& key, int fallback) {
  if (!Has(key)) return fallback;
  int value = 0;
  if (!Convert(Get(key), &value)) Fail(key, "an integer");
  return value;
}

uint64_t YamlMap::Seed(const std::string& key, uint64_t fallback) {
  if (!Has(key)) return fallback;
  uint64_t value = 0;
  if (!Convert(Get(key), &value)) Fail(key, "an integer of 0 or more");
  return value;
}

bool YamlMap::Flag(const std::string& key, bool fallback) {
  if (!Has(key)) return fallback;
  bool value = false;
  if (!Convert(Get(key), &value)) Fail(key, "true or false");
  return value;
}

std::string YamlMap::Text(const std::string& key) {
  const YAML::Node node = Get(key);
  if (!node.IsScalar()) Fail(key, "a text");
  return node.Scalar();
}

std::string YamlMap::Text(const std::string& key, const std::string& fallback) {
  return Has(key) ? Text(key) : fallback;
}

std::vector<double> YamlMap::Numbers(const std::string& key, size_t count) {
  const YAML::Node node = Get(key);
  const std::string expected = std::to_string(count) + " numbers";
  if (!node.IsSequence() || node.size() != count) Fail(key, expected);
  std::vector<double> values(count);
  for (size_t i = 0; i < count; ++i) {
    if (!ConvertFinite(node[i], &values[i])) Fail(key, expected);
  }
  return values;
}

std::vector<std::string> YamlMap::Texts(const std::string& key) {
  if (!Has(key)) return {};
  const YAML::Node node = Get(key);
  if (!node.IsSequence()) Fail(key, "a list of texts");
  std::vector<std::string> texts;
  for (const YAML::Node& item : node) {
    if (!item.IsScalar()) Fail(key, "a list of texts");
    texts.push_back(item.Scalar());
  }
  return texts;
}

std::vector<YamlMap> YamlMap::List(const std::string& key) {
  if (!Has(key)) return {};
  const YAML::Node node = Get(key);
  if (!node.IsSequence()) Fail(key, "a list");
  std::vector<YamlMap> items;
  for (const YAML::Node& item : node) {
    items.emplace_back(item, where_ + "." + key + "[" + std::to_string(items.size()) + "]");
  }
  return items;
}

std::vector<std::vector<double>> YamlMap::Rows(const std::string& key, size_t count) {
  const YAML::Node node = Get(key);
  if (!node.IsSequence()) Fail(key, "a list of lists");
  std::vector<std::vector<double>> rows;
  for (const YAML::Node& item : node) {
    YAML::Node wrapped;
    wrapped[key] = item;
    rows.push_back(YamlMap(wrapped, where_).Numbers(key, count));
  }
  return rows;
}

Rigid3 YamlMap::Placement() {
  Rigid3 placement;
  if (Has("at_m")) {
    const std::vector<double> at_m = Numbers("at_m", 3);
    placement.translation = {at_m[0], at_m[1], at_m[2]};
  }
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  placement.rotation = AngleAxisd(Radians(Number("yaw_deg", 0.0)), Vector3d::UnitZ()) *
                       AngleAxisd(Radians(Number("pitch_deg", 0.0)), Vector3d::UnitY()) *
                       AngleAxisd(Radians(Number("roll_deg", 0.0)), Vector3d::UnitX());
  return placement;
}

void YamlMap::RefuseUnknownKeys() const {
  for (const auto& [key, node] : entries_) {
    if (used_.count(key) == 0) throw std::runtime_error(where_ + ": unknown key " + key);
  }
}

}  // namespace rovio_sfm::sim
