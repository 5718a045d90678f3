#pragma once

#include <sstream>
#include <string>
#include <utility>

namespace rovio_sfm {

// Collects the first complaint about an options struct: group, name, value and bound. NaN never
// passes. error is borrowed and may be null.
class OptionChecker {
 public:
  OptionChecker(std::string group, std::string* error) : group_(std::move(group)), error_(error) {}

  // low <= value <= high, bounds allowed.
  template <typename T>
  void Range(const char* name, T value, T low, T high) {
    if (value >= low && value <= high) return;
    std::ostringstream out;
    out << group_ << "." << name << " = " << value << ": expected " << low << " to " << high;
    Fail(out.str());
  }

  void True(const char* name, bool condition, const char* expected) {
    if (!condition) Fail(group_ + "." + name + ": expected " + expected);
  }

  // Takes over the complaint of a nested struct's IsValid.
  template <typename Options>
  void Nested(const Options& options) {
    std::string nested_error;
    if (!options.IsValid(&nested_error)) Fail(nested_error);
  }

  bool Passed() const { return passed_; }

 private:
  void Fail(const std::string& message) {
    if (passed_ && error_ != nullptr) *error_ = message;
    passed_ = false;
  }

  std::string group_;
  std::string* error_;
  bool passed_ = true;
};

}  // namespace rovio_sfm
