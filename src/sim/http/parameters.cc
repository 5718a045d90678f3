#include "rovio_sfm/sim/http/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace rovio_sfm::sim {
namespace {

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::string DecodeUrl(std::string_view text, bool plus_is_blank) {
  std::string decoded;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && HexDigit(text[i + 1]) >= 0 &&
                        HexDigit(text[i + 2]) >= 0;
    if (escape) {
      decoded += static_cast<char>(HexDigit(text[i + 1]) * 16 + HexDigit(text[i + 2]));
      i += 2;
    } else {
      decoded += plus_is_blank && text[i] == '+' ? ' ' : text[i];
    }
  }
  return decoded;
}

std::optional<long> ParseLong(std::string_view text) {
  long value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> ParseDouble(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

Parameters Parameters::Parse(std::string_view query) {
  Parameters parameters;
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    if (pair.empty()) continue;
    const size_t equals = std::min(pair.find('='), pair.size());
    const std::string_view value = pair.substr(std::min(pair.size(), equals + 1));
    parameters.pairs_.emplace_back(DecodeUrl(pair.substr(0, equals), true), DecodeUrl(value, true));
  }
  return parameters;
}

bool Parameters::Has(std::string_view name) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [name](const auto& pair) { return pair.first == name; });
}

std::string Parameters::Get(std::string_view name) const {
  const auto found = std::find_if(pairs_.begin(), pairs_.end(),
                                  [name](const auto& pair) { return pair.first == name; });
  return found == pairs_.end() ? std::string() : found->second;
}

std::optional<long> Parameters::GetLong(std::string_view name) const {
  return ParseLong(Get(name));
}

bool Parameters::GetBool(std::string_view name) const {
  const std::string text = Lower(Get(name));
  return text == "true" || text == "yes" || text == "on" || ParseLong(text).value_or(0) != 0;
}

std::vector<std::string> SplitCommands(std::string_view query) {
  constexpr std::string_view kMark = "&Cmd=";
  std::vector<std::string> pieces;
  for (size_t cut = query.find(kMark); cut != std::string_view::npos; cut = query.find(kMark)) {
    pieces.emplace_back(query.substr(0, cut));
    query.remove_prefix(cut + 1);
  }
  pieces.emplace_back(query);
  return pieces;
}

}  // namespace rovio_sfm::sim
