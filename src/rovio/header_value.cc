#include "rovio_sfm/rovio/header_value.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace rovio_sfm {

std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool EqualsIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

std::optional<std::string_view> HeaderValue(std::string_view line, std::string_view name) {
  const size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  if (!EqualsIgnoringCase(Trim(line.substr(0, colon)), name)) return std::nullopt;
  return Trim(line.substr(colon + 1));
}

std::optional<size_t> ParseContentLength(std::string_view value) {
  size_t length = 0;
  const char* const end = value.data() + value.size();
  const auto [parsed_to, error] = std::from_chars(value.data(), end, length);
  if (value.empty() || error != std::errc() || parsed_to != end) return std::nullopt;
  return length;
}

}  // namespace rovio_sfm
