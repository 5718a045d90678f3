#include "rovio_sfm/app/option_reader.h"

#include <sstream>
#include <utility>

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
    : OptionReader(YamlMap(node, path)) {}

OptionReader::OptionReader(YamlMap map)
    : map_(std::move(map)), effective_(std::make_shared<std::vector<std::string>>()) {}

OptionReader OptionReader::Group(const std::string& name) {
  OptionReader group(map_.Group(name));
  group.effective_ = effective_;
  return group;
}

template <typename T>
void OptionReader::ReadScalar(const std::string& name, const std::string& expected, T* value) {
  map_.Read(name, expected, value);
  effective_->push_back(map_.PathOf(name) + " = " + Text(*value));
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
