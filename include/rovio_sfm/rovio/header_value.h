#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace rovio_sfm {

// The value of "Name: value" without blanks round it when the line has that name, letter case
// aside; else nothing.
std::optional<std::string_view> HeaderValue(std::string_view line, std::string_view name);

// A length made of decimal digits only; nothing when it is empty, negative or overflows.
std::optional<size_t> ParseContentLength(std::string_view value);

// Without blanks and line ends at both ends.
std::string_view Trim(std::string_view text);

// Equal, the case of ASCII letters aside.
bool EqualsIgnoringCase(std::string_view a, std::string_view b);

}  // namespace rovio_sfm
