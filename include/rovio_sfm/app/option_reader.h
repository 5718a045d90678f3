#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/util/yaml_map.h"

namespace rovio_sfm {

// Reads one group of options from YAML (YamlMap) and keeps what is in effect: fields that are
// missing keep their defaults.
class OptionReader {
 public:
  // A null node is an empty group. `path` names the group in messages, e.g. "mapper".
  OptionReader(const YAML::Node& node, const std::string& path);

  void Read(const std::string& name, bool* value) { ReadScalar(name, "true or false", value); }
  void Read(const std::string& name, int* value) { ReadScalar(name, "a whole number", value); }
  void Read(const std::string& name, uint32_t* value) {
    ReadScalar(name, "a whole number, 0 or more", value);
  }
  void Read(const std::string& name, uint64_t* value) {
    ReadScalar(name, "a whole number, 0 or more", value);
  }
  void Read(const std::string& name, float* value) { ReadScalar(name, "a number", value); }
  void Read(const std::string& name, double* value) { ReadScalar(name, "a number", value); }
  void Read(const std::string& name, std::string* value) { ReadScalar(name, "text", value); }
  void Read(const std::string& name, std::vector<std::string>* value) {
    ReadScalar(name, "a list of texts", value);
  }

  void Read(const std::string& name, std::vector<double>* value) {
    ReadScalar(name, "a list of numbers", value);
  }
  void Read(const std::string& name, std::vector<int>* value) {
    ReadScalar(name, "a list of whole numbers", value);
  }

  // The group of that name below this one; empty where it is missing.
  OptionReader Group(const std::string& name);

  // Names the first key that was not read.
  void RefuseUnknown() const { map_.RefuseUnknownKeys(); }

  // "path.name = value" of everything read so far, groups included, in the order read.
  const std::vector<std::string>& Effective() const { return *effective_; }

  // Throws with "path.name: reason".
  [[noreturn]] void Fail(const std::string& name, const std::string& reason) const {
    map_.Fail(name, reason);
  }

 private:
  template <typename T>
  void ReadScalar(const std::string& name, const std::string& expected, T* value);

  explicit OptionReader(YamlMap map);

  YamlMap map_;
  std::shared_ptr<std::vector<std::string>> effective_;  // shared with the groups below
};

}  // namespace rovio_sfm
