#include "rovio_sfm/io/text_file.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxTextBytes = 256u << 20;
constexpr size_t kMaxLineBytes = 4096;
// Until 2106, as ROS counts: the difference of any two stamps fits into 64 bits of nanoseconds.
constexpr int64_t kMaxSeconds = 4'294'967'295;

bool IsDigits(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<std::string> Split(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> fields;
  for (std::string field; stream >> field;) fields.push_back(field);
  return fields;
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
  const std::string& text = fields.at(field);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    Fail(std::string("field ") + name + ": expected a finite number, got '" + text + "'");
  }
  return value;
}

int64_t TextLine::Stamp(size_t field, const char* name) const {
  const std::optional<int64_t> stamp = StampFromDecimal(fields.at(field));
  if (!stamp) {
    Fail(std::string("field ") + name + ": expected decimal seconds, got '" + fields[field] + "'");
  }
  return *stamp;
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
  std::istringstream stream(std::string(bytes.begin(), bytes.end()));
  std::vector<TextLine> lines;
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    TextLine line{path.string(), ++number, {}};
    if (text.size() > kMaxLineBytes) line.Fail("line longer than 4096 bytes");
    line.fields = Split(text);
    if (!line.fields.empty() && line.fields.front().front() != '#') lines.push_back(line);
  }
  return lines;
}

std::vector<uint8_t> ReadBytes(const std::filesystem::path& path, uintmax_t max_bytes) {
  std::error_code error;
  const uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw std::runtime_error(path.string() + ": " + error.message());
  if (size > max_bytes) {
    throw std::runtime_error(path.string() + ": " + std::to_string(size) + " bytes, more than " +
                             std::to_string(max_bytes));
  }
  std::vector<uint8_t> bytes(size);
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream) throw std::runtime_error(path.string() + ": cannot be read");
  return bytes;
}

std::optional<int64_t> StampFromDecimal(const std::string& seconds) {
  const bool negative = !seconds.empty() && seconds.front() == '-';
  const std::string text = seconds.substr(negative ? 1 : 0);
  const size_t point = text.find('.');
  const std::string whole = text.substr(0, point);
  std::string fraction = point == std::string::npos ? "" : text.substr(point + 1);
  if (whole.empty() || whole.size() > 10 || !IsDigits(whole) || !IsDigits(fraction)) {
    return std::nullopt;
  }
  fraction.resize(9, '0');
  const int64_t whole_s = std::strtoll(whole.c_str(), nullptr, 10);
  if (whole_s > kMaxSeconds) return std::nullopt;
  const int64_t stamp_ns = whole_s * 1'000'000'000 + std::strtoll(fraction.c_str(), nullptr, 10);
  return negative ? -stamp_ns : stamp_ns;
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
