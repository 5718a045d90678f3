#include "rovio_sfm/io/text_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxTextBytes = 256u << 20;
constexpr size_t kMaxLineBytes = 4096;
constexpr size_t kPieceBytes = 64u << 10;
// Until 2106, as ROS counts: the difference of any two stamps fits into 64 bits of nanoseconds.
constexpr int64_t kMaxSeconds = 4'294'967'295;

bool IsDigits(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos;
}

constexpr char kByteOrderMark[] = "\xEF\xBB\xBF";
constexpr int kMaxExponent = 30;
constexpr size_t kMaxSecondDigits = 10, kMinNanosecondDigits = 17, kMaxNanosecondDigits = 19;

// A number without its sign: digits and how many of them stand before the point.
struct Decimal {
  std::string digits;
  int num_whole = 0;
};

std::optional<int> ExponentFrom(const std::string& text) {
  const std::string number = text.substr(!text.empty() && text.front() == '+' ? 1 : 0);
  int exponent = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), exponent);
  if (error != std::errc() || end != number.data() + number.size()) return std::nullopt;
  if (exponent < -kMaxExponent || exponent > kMaxExponent) return std::nullopt;
  return exponent;
}

std::optional<Decimal> DecimalFrom(const std::string& text) {
  const size_t e = text.find_first_of("eE");
  const std::string mantissa = text.substr(0, e);
  const auto exponent = e == std::string::npos ? 0 : ExponentFrom(text.substr(e + 1));
  const size_t point = mantissa.find('.');
  const std::string whole = mantissa.substr(0, point);
  const std::string fraction = point == std::string::npos ? "" : mantissa.substr(point + 1);
  if (!exponent || whole.empty() || !IsDigits(whole) || !IsDigits(fraction)) return std::nullopt;
  return Decimal{whole + fraction, static_cast<int>(whole.size()) + *exponent};
}

// The digits before the point, without leading zeros, and nine after it.
std::pair<std::string, std::string> SplitAtPoint(Decimal decimal) {
  if (decimal.num_whole < 0) {
    decimal.digits.insert(0, static_cast<size_t>(-decimal.num_whole), '0');
    decimal.num_whole = 0;
  }
  const auto num_whole = static_cast<size_t>(decimal.num_whole);
  decimal.digits.resize(std::max(decimal.digits.size(), num_whole), '0');
  std::string fraction = decimal.digits.substr(num_whole);
  fraction.resize(9, '0');
  std::string whole = decimal.digits.substr(0, num_whole);
  whole.erase(0, whole.find_first_not_of('0'));
  return {whole, fraction};
}

// Bytes that no UTF-8 text begins with.
bool IsUtf16(const std::string& text) {
  return text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0;
}

std::vector<std::string> Split(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> fields;
  for (std::string field; stream >> field;) fields.push_back(field);
  return fields;
}

// Nothing where only reading tells it: of a pipe, of a terminal. Throws where there is no file.
std::optional<uintmax_t> SizeOf(const std::filesystem::path& path) {
  std::error_code error;
  const uintmax_t size = std::filesystem::file_size(path, error);
  if (!error) return size;
  if (error == std::errc::not_supported || error == std::errc::operation_not_supported) {
    return std::nullopt;
  }
  throw std::runtime_error(path.string() + ": " + error.message());
}

[[noreturn]] void FailTooLarge(const std::filesystem::path& path, const std::string& found,
                               uintmax_t max_bytes) {
  throw std::runtime_error(path.string() + ": " + found + std::to_string(max_bytes));
}

}  // namespace

void TextLine::Fail(const std::string& reason) const {
  throw std::runtime_error(file + ":" + std::to_string(number) + ": " + reason);
}

void TextLine::RequireFields(size_t count, const std::string& layout) const {
  if (fields.size() == count) return;
  Fail("expected " + std::to_string(count) + " fields (" + layout + "), got " +
       std::to_string(fields.size()));
}

double TextLine::Number(size_t field, const char* name) const {
  const std::string& digits = fields.at(field);
  const bool has_plus = digits.size() > 1 && digits[0] == '+' && digits[1] != '-';
  const char* begin = digits.data() + (has_plus ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    Fail(std::string("field ") + name + ": expected a finite number, got '" + digits + "'");
  }
  return value;
}

int64_t TextLine::Stamp(size_t field, const char* name) const {
  const std::optional<int64_t> stamp = StampFromDecimal(fields.at(field));
  if (!stamp) {
    Fail(std::string("field ") + name +
         ": expected seconds, or nanoseconds of 17 to 19 digits, got '" + fields[field] + "'");
  }
  return *stamp;
}

std::string TextLine::From(size_t field) const {
  size_t begin = 0;
  for (size_t i = 0; i <= field; ++i) {
    begin = text.find(fields.at(i), begin);
    if (i < field) begin += fields[i].size();
  }
  return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

int TextLine::PositiveInteger(size_t field, const char* name) const {
  const double value = Number(field, name);
  if (value != std::floor(value) || value < 1.0 || value > 1e6) {
    Fail(std::string("field ") + name + ": expected an integer of 1 to 1000000, got '" +
         fields[field] + "'");
  }
  return static_cast<int>(value);
}

std::vector<TextLine> ReadTextFile(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = ReadBytes(path, kMaxTextBytes);
  std::string all(bytes.begin(), bytes.end());
  if (IsUtf16(all)) throw std::runtime_error(path.string() + ": UTF-16 text; expected UTF-8");
  if (all.compare(0, 3, kByteOrderMark) == 0) all.erase(0, 3);
  std::istringstream stream(all);
  std::vector<TextLine> lines;
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    TextLine line{path.string(), ++number, {}};
    if (text.size() > kMaxLineBytes) line.Fail("line longer than 4096 bytes");
    line.fields = Split(text);
    line.text = text;
    if (!line.fields.empty() && line.fields.front().front() != '#') lines.push_back(line);
  }
  return lines;
}

std::vector<uint8_t> ReadBytes(const std::filesystem::path& path, uintmax_t max_bytes) {
  const std::optional<uintmax_t> size = SizeOf(path);
  if (size > max_bytes) FailTooLarge(path, std::to_string(*size) + " bytes, more than ", max_bytes);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(path.string() + ": " + std::strerror(errno));
  std::vector<uint8_t> bytes;
  bytes.reserve(size.value_or(0));
  for (std::vector<char> piece(kPieceBytes); stream && bytes.size() <= max_bytes;) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + stream.gcount());
  }
  if (stream.bad()) throw std::runtime_error(path.string() + ": cannot be read");
  if (bytes.size() > max_bytes) FailTooLarge(path, "more bytes than ", max_bytes);
  return bytes;
}

std::optional<int64_t> StampFromDecimal(const std::string& number) {
  const bool has_sign = !number.empty() && (number.front() == '-' || number.front() == '+');
  const std::optional<Decimal> decimal = DecimalFrom(number.substr(has_sign ? 1 : 0));
  if (!decimal) return std::nullopt;
  const auto [whole, fraction] = SplitAtPoint(*decimal);
  const bool is_nanoseconds =
      whole.size() >= kMinNanosecondDigits && whole.size() <= kMaxNanosecondDigits;
  if (whole.size() > kMaxSecondDigits && !is_nanoseconds) return std::nullopt;
  // Of digits alone, at most 19 of them.
  const uint64_t stamp_ns =
      std::strtoull((is_nanoseconds ? whole : whole + fraction).c_str(), nullptr, 10);
  if (stamp_ns / 1'000'000'000 > static_cast<uint64_t>(kMaxSeconds)) return std::nullopt;
  const auto magnitude = static_cast<int64_t>(stamp_ns);
  return number.front() == '-' ? -magnitude : magnitude;
}

std::string DecimalFromStamp(int64_t stamp_ns) {
  const uint64_t magnitude =
      stamp_ns < 0 ? 0 - static_cast<uint64_t>(stamp_ns) : static_cast<uint64_t>(stamp_ns);
  std::string fraction = std::to_string(magnitude % 1'000'000'000);
  fraction.insert(0, 9 - fraction.size(), '0');
  if (magnitude % 1000 == 0) fraction.resize(6);
  return (stamp_ns < 0 ? "-" : "") + std::to_string(magnitude / 1'000'000'000) + "." + fraction;
}

}  // namespace rovio_sfm
