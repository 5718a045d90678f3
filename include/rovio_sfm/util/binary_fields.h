#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace rovio_sfm {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files are little-endian");

// Appends plain values to bytes, little-endian and unpadded.
class FieldWriter {
 public:
  template <typename T>
  void Write(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <typename T>
  void WriteAll(const std::vector<T>& values) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void WriteText(const std::string& text) {
    Write(static_cast<uint32_t>(text.size()));
    bytes_ += text;
  }

  const std::string& Bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Reads them back from untrusted bytes (borrowed). Throws std::runtime_error that names file and
// field where the bytes end too soon, before anything of that size is allocated.
class FieldReader {
 public:
  FieldReader(const uint8_t* data, size_t size, std::string file)
      : data_(data), size_(size), file_(std::move(file)) {}

  template <typename T>
  T Read(const char* field) {
    T value;
    Require(1, sizeof(T), field);
    std::memcpy(&value, data_ + position_, sizeof(T));
    position_ += sizeof(T);
    return value;
  }
  // A value between low and high.
  template <typename T>
  T ReadBetween(const char* field, T low, T high) {
    const T value = Read<T>(field);
    if (value >= low && value <= high) return value;
    Fail(std::string(field) + " = " + std::to_string(value) + ": expected " + std::to_string(low) +
         " to " + std::to_string(high));
  }
  template <typename T>
  std::vector<T> ReadAll(const char* field, size_t count) {
    Require(count, sizeof(T), field);
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), data_ + position_, count * sizeof(T));
    position_ += count * sizeof(T);
    return values;
  }
  std::string ReadText(const char* field, uint32_t max_length) {
    const std::vector<char> text = ReadAll<char>(field, ReadBetween(field, 0u, max_length));
    return std::string(text.begin(), text.end());
  }
  void RequireEnd() {
    if (Left() > 0) Fail(std::to_string(Left()) + " bytes too many");
  }

  size_t Left() const { return size_ - position_; }
  const uint8_t* Position() const { return data_ + position_; }
  [[noreturn]] void Fail(const std::string& reason) const {
    throw std::runtime_error(file_ + ": " + reason);
  }

 private:
  void Require(size_t count, size_t size, const char* field) const {
    if (count <= Left() / size) return;
    Fail(std::string("cut short at ") + field + ": needs " + std::to_string(count * size) +
         " bytes, " + std::to_string(Left()) + " are left");
  }

  const uint8_t* data_;
  size_t size_;
  size_t position_ = 0;
  std::string file_;
};

}  // namespace rovio_sfm
