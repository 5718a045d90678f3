#include "rovio_sfm/app/option_reader.h"

#include <sstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

template <typename T>
std::string Text(const T& value) {
  std::ostringstream out;
  out << std::boolalpha << value;
  return out.str();
}

template <typename T>
std::string Text(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() > 1 ? ", " : "") + Text(value);
  return text + "]";
}

}  // namespace

OptionReader::OptionReader(const YAML::Node& node, const std::string& path)
    : node_(node), path_(path), effective_(std::make_shared<std::vector<std::string>>()) {
  const bool is_empty = !node_.IsDefined() || node_.IsNull();
  if (!is_empty && !node_.IsMap())
    throw std::runtime_error(path_ + ": expected a group of options");
}

OptionReader OptionReader::Group(const std::string& name) {
  known_.insert(name);
  const YAML::Node child = node_.IsMap() ? YAML::Node(node_[name]) : YAML::Node();
  OptionReader group(child, PathOf(name));
  group.effective_ = effective_;
  return group;
}

void OptionReader::RefuseUnknown() const {
  if (!node_.IsDefined() || !node_.IsMap()) return;
  for (const auto& entry : node_) {
    const auto name = entry.first.as<std::string>();
    if (known_.count(name) == 0) Fail(name, "unknown option");
  }
}

void OptionReader::Fail(const std::string& name, const std::string& reason) const {
  throw std::runtime_error(PathOf(name) + ": " + reason);
}

std::string OptionReader::PathOf(const std::string& name) const {
  return path_.empty() ? name : path_ + "." + name;
}

template <typename T>
void OptionReader::ReadScalar(const std::string& name, const std::string& expected, T* value) {
  known_.insert(name);
  const YAML::Node& node = node_;  // operator[] of a const node adds nothing
  if (node.IsDefined() && node.IsMap() && node[name].IsDefined()) {
    try {
      *value = node[name].as<T>();
    } catch (const YAML::Exception&) {
      Fail(name, "expected " + expected);
    }
  }
  effective_->push_back(PathOf(name) + " = " + Text(*value));
}

template void OptionReader::ReadScalar(const std::string&, const std::string&, bool*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, int*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, uint32_t*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, uint64_t*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, float*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, double*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, std::string*);
template void OptionReader::ReadScalar(const std::string&, const std::string&,
                                       std::vector<double>*);
template void OptionReader::ReadScalar(const std::string&, const std::string&, std::vector<int>*);
template void OptionReader::ReadScalar(const std::string&, const std::string&,
                                       std::vector<std::string>*);

}  // namespace rovio_sfm
