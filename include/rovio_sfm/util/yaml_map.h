#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rovio_sfm {

// A YAML mapping that is read key by key; every fault is a std::runtime_error that names where it
// lies. RefuseUnknownKeys() refuses keys that nobody asked for. Numbers are finite.
class YamlMap {
 public:
  // No node, or a null one, is an empty mapping. Messages begin with `where`, the separator and
  // the key.
  YamlMap(const YAML::Node& node, std::string where, std::string separator = ".");

  bool Has(const std::string& key) const { return entries_.count(key) == 1; }

  // Where the key is there: its value. `expected` says in messages what it should have been.
  template <typename T>
  void Read(const std::string& key, const std::string& expected, T* value);

  double Number(const std::string& key);
  double Number(const std::string& key, double fallback);
  int Integer(const std::string& key, int fallback);
  uint64_t Seed(const std::string& key, uint64_t fallback);
  std::string Text(const std::string& key);
  std::vector<double> Numbers(const std::string& key, size_t count);
  // Empty if the key is missing, like the other lists.
  std::vector<std::string> Texts(const std::string& key);
  // The items of a list of mappings.
  std::vector<YamlMap> List(const std::string& key);
  // The items of a list of number lists, each of the given length.
  std::vector<std::vector<double>> Rows(const std::string& key, size_t count);
  // The mapping of that key; empty where it is missing.
  YamlMap Group(const std::string& key);

  void RefuseUnknownKeys() const;

  // "where.key".
  std::string PathOf(const std::string& key) const;
  // Throws with "where.key: reason".
  [[noreturn]] void Fail(const std::string& key, const std::string& reason) const;

 private:
  YAML::Node Get(const std::string& key);

  std::map<std::string, YAML::Node> entries_;  // looked up often; a node searches slowly
  std::string where_, separator_;
  std::set<std::string> used_;
};

}  // namespace rovio_sfm
