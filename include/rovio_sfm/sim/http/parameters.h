#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rovio_sfm::sim {

// The decoded name=value pairs of a query string, in order; of a repeated name the first counts.
class Parameters {
 public:
  static Parameters Parse(std::string_view query);

  bool Has(std::string_view name) const;
  std::string Get(std::string_view name) const;              // empty when absent
  std::optional<long> GetLong(std::string_view name) const;  // nothing when absent or no number
  bool GetBool(std::string_view name) const;                 // true, yes, on or a number but 0

  const std::vector<std::pair<std::string, std::string>>& pairs() const { return pairs_; }

 private:
  std::vector<std::pair<std::string, std::string>> pairs_;
};

// Undoes %XX, and + for a blank when wanted; malformed escapes stay as they are.
std::string DecodeUrl(std::string_view text, bool plus_is_blank);

// The whole text as a decimal number, or nothing.
std::optional<long> ParseLong(std::string_view text);
std::optional<double> ParseDouble(const std::string& text);

// The query cut before each "&Cmd=", so that every piece holds the parameters of one command.
std::vector<std::string> SplitCommands(std::string_view query);

}  // namespace rovio_sfm::sim
