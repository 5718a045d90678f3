#pragma once

#include <charconv>
#include <cstring>
#include <string>
#include <type_traits>

// How exporters put numbers into a file.
namespace rovio_sfm {

// The bytes of a number; the hosts of ROS are little-endian, as the files are.
template <typename T>
void AppendBytes(T value, std::string* bytes) {
  static_assert(std::is_arithmetic_v<T>, "a number is expected");
  char buffer[sizeof(T)];
  std::memcpy(buffer, &value, sizeof(T));
  bytes->append(buffer, sizeof(T));
}

// The shortest text that reads back as the same number.
template <typename T>
void AppendNumber(T value, std::string* text) {
  static_assert(std::is_arithmetic_v<T>, "a number is expected");
  char buffer[32];
  text->append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

// Numbers, a space before each but the first of a line.
template <typename... Values>
void AppendFields(std::string* text, const Values&... values) {
  const auto append = [text](auto value) {
    if (!text->empty() && text->back() != '\n') text->push_back(' ');
    AppendNumber(value, text);
  };
  (append(values), ...);
}

}  // namespace rovio_sfm
