#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace rovio_sfm {

// The one document of a text; an undefined node of none. Throws YAML::Exception where it is no
// YAML, or a second document follows.
YAML::Node LoadDocument(const std::string& yaml);

// Whether a text is a whole number as people write it: YAML 1.1 takes 0777 for octal.
bool IsDecimal(const std::string& text);

}  // namespace rovio_sfm
