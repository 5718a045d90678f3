#include "rovio_sfm/util/parse_arguments.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace rovio_sfm {
namespace {

// CLI11's names of the types of options.
constexpr char kWhole[] = "INT", kWholeFromZero[] = "UINT", kDecimal[] = "FLOAT";

bool IsOfType(const CLI::Option& option, const std::string& type) {
  const std::string name = option.get_type_name();  // then what its checks say
  return name == type || name.rfind(type + ":", 0) == 0 || name.rfind(type + " ", 0) == 0;
}

std::string Complaint(const std::string& expected, const std::string& value) {
  return "expected " + expected + ", not '" + value + "'";
}

// Without a plus and leading zeros, which CLI11 would take for octal; empty: no whole number.
std::string DecimalText(const std::string& value) {
  const bool is_negative = value.rfind('-', 0) == 0;
  const std::string digits = value.substr(is_negative || value.rfind('+', 0) == 0 ? 1 : 0);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) return "";
  const size_t first = digits.find_first_not_of('0');
  return (is_negative ? "-" : "") + (first == std::string::npos ? "0" : digits.substr(first));
}

template <typename Number>
bool Fits(const std::string& text) {
  Number number{};
  return std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc();
}

// Before an option's own checks, which would call a fraction out of range.
std::string ReadWhole(std::string& value) {
  const std::string text = DecimalText(value);
  if (text.empty()) return Complaint("a whole number", value);
  if (!Fits<int64_t>(text) && !Fits<uint64_t>(text)) {
    return Complaint("a whole number of at most 64 bits", value);
  }
  value = text;
  return "";
}

// After them: where an option has a range of its own, that is told.
std::string RefuseNegative(const std::string& value) {
  if (Fits<uint64_t>(value)) return "";
  return Complaint("a whole number, 0 to " + std::to_string(std::numeric_limits<uint64_t>::max()),
                   value);
}

// Before an option's own checks: no range that CLI11 knows leaves out what is no number.
std::string RefuseNotFinite(const std::string& value) {
  const std::string text = value.substr(value.rfind('+', 0) == 0 ? 1 : 0);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_read = error == std::errc() && end == text.data() + text.size();
  return is_read && std::isfinite(number) ? "" : Complaint("a finite number", value);
}

void CheckNumbers(CLI::App* app) {
  for (CLI::Option* option : app->get_options()) {
    const bool is_from_zero = IsOfType(*option, kWholeFromZero);
    if (is_from_zero) option->check(RefuseNegative, "");
    if (IsOfType(*option, kDecimal)) option->transform(CLI::Validator(RefuseNotFinite, ""));
    if (is_from_zero || IsOfType(*option, kWhole)) option->transform(CLI::Validator(ReadWhole, ""));
  }
  for (CLI::App* command : app->get_subcommands([](CLI::App*) { return true; })) {
    CheckNumbers(command);
  }
}

}  // namespace

std::optional<int> ParseArguments(CLI::App* app, int argc, const char* const* argv,
                                  std::ostream& out) {
  CheckNumbers(app);
  try {
    app->parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app->exit(asked, out, out);
  } catch (const CLI::ParseError& error) {
    throw std::runtime_error(error.what() + std::string("\nRun with --help for more information."));
  }
  return std::nullopt;
}

}  // namespace rovio_sfm
