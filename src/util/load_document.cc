#include "rovio_sfm/util/load_document.h"

#include <vector>

namespace rovio_sfm {

YAML::Node LoadDocument(const std::string& yaml) {
  const std::vector<YAML::Node> documents = YAML::LoadAll(yaml);
  for (size_t i = 1; i < documents.size(); ++i) {
    if (documents[i].IsNull()) continue;
    throw YAML::ParserException(documents[i].Mark(), "a second document: expected one");
  }
  return documents.empty() ? YAML::Node() : documents.front();
}

bool IsDecimal(const std::string& text) {
  const std::string digits = text.substr(!text.empty() && (text[0] == '-' || text[0] == '+'));
  const bool has_leading_zero = digits.size() > 1 && digits.front() == '0';
  return !digits.empty() && !has_leading_zero &&
         digits.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace rovio_sfm
