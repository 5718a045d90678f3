#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm::sim {

// A YAML mapping that is read key by key; every fault is a std::runtime_error that names where it
// lies. RefuseUnknownKeys() refuses keys that nobody asked for.
class YamlMap {
 public:
  YamlMap(const YAML::Node& node, std::string where);

  bool Has(const std::string& key) const;
  const std::string& where() const { return where_; }

  double Number(const std::string& key);
  double Number(const std::string& key, double fallback);
  int Integer(const std::string& key, int fallback);
  uint64_t Seed(const std::string& key, uint64_t fallback);
  bool Flag(const std::string& key, bool fallback);
  std::string Text(const std::string& key);
  std::string Text(const std::string& key, const std::string& fallback);
  std::vector<double> Numbers(const std::string& key, size_t count);
  std::vector<std::string> Texts(const std::string& key);
  // The items of a list of mappings; empty if the key is missing.
  std::vector<YamlMap> List(const std::string& key);
  // The items of a list of number lists, each of the given length.
  std::vector<std::vector<double>> Rows(const std::string& key, size_t count);
  // at_m [x, y, z], yaw_deg, pitch_deg, roll_deg (turned in the order z, y, x); missing means 0.
  Rigid3 Placement();

  void RefuseUnknownKeys() const;

 private:
  YAML::Node Get(const std::string& key);
  [[noreturn]] void Fail(const std::string& key, const std::string& expected) const;

  std::map<std::string, YAML::Node> entries_;  // looked up often; a node searches slowly
  std::string where_;
  std::set<std::string> used_;
};

}  // namespace rovio_sfm::sim
