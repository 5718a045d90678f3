#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rovio_sfm {

// One line of a text file, split at white space; its methods throw std::runtime_error that names
// file, line, field and what was expected.
struct TextLine {
  std::string file;
  int number = 0;  // from 1
  std::vector<std::string> fields;
  std::string text = {};  // the whole line, without what ends it

  void RequireFields(size_t count, const std::string& layout) const;
  double Number(size_t field, const char* name) const;        // finite
  int64_t Stamp(size_t field, const char* name) const;        // as StampFromDecimal
  int PositiveInteger(size_t field, const char* name) const;  // 1 … 1e6
  std::string From(size_t field) const;  // the rest of the line, blanks inside it included
  [[noreturn]] void Fail(const std::string& reason) const;
};

// The lines of a UTF-8 text file but comments (#) and blank ones; a byte order mark is passed over,
// lines may end as on Windows. Throws std::runtime_error where the file cannot be read, is UTF-16,
// larger than 256 MB or has a line longer than 4096 bytes.
std::vector<TextLine> ReadTextFile(const std::filesystem::path& path);

// All bytes of a file, or of a pipe until it ends, of at most max_bytes; throws std::runtime_error
// otherwise.
std::vector<uint8_t> ReadBytes(const std::filesystem::path& path, uintmax_t max_bytes);

// A decimal number, with an exponent or without, as nanoseconds: seconds, exact to nine decimals,
// or, where 17 to 19 digits stand before the point, nanoseconds. Digits after them are cut. Nothing
// for anything else.
std::optional<int64_t> StampFromDecimal(const std::string& number);

// Nanoseconds as decimal seconds: six decimals where they say all, else nine.
std::string DecimalFromStamp(int64_t stamp_ns);

}  // namespace rovio_sfm
