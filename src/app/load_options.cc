#include "rovio_sfm/app/load_options.h"

#include "rovio_sfm/util/log.h"
#include "rovio_sfm/util/option_text.h"

namespace rovio_sfm {
namespace {

template <typename Value>
void ReadValue(const OptionRow& row, OptionReader* reader, Value* value) {
  reader->Read(row.name, value);
}

void ReadValue(const OptionRow& row, OptionReader* reader, std::string* value) {
  reader->Read(row.name, value);
  std::string complaint = row.choices.empty() ? "" : "expected " + RangeText(row);
  for (const std::string& choice : row.choices) {
    if (choice == *value) complaint.clear();
  }
  if (!complaint.empty()) reader->Fail(row.name, complaint + ", not '" + *value + "'");
}

// The table wants as many numbers as the field holds.
template <typename Number>
void ReadNumbers(const OptionRow& row, OptionReader* reader, std::vector<Number>* values) {
  const size_t num_wanted = values->size();
  reader->Read(row.name, values);
  if (values->size() == num_wanted) return;
  reader->Fail(row.name, "expected " + std::to_string(num_wanted) + " numbers");
}

void ReadValue(const OptionRow& row, OptionReader* reader, std::vector<int>* values) {
  ReadNumbers(row, reader, values);
}

void ReadValue(const OptionRow& row, OptionReader* reader, std::vector<double>* values) {
  ReadNumbers(row, reader, values);
}

}  // namespace

void LoadTable::VisitOption(const OptionRow& row, OptionValue value) {
  std::visit([&](auto* field) { ReadValue(row, &readers_.back(), field); }, value);
}

void LoadTable::BeginGroup(const char* name, const char* /*reason*/) {
  readers_.push_back(readers_.back().Group(name));
}

void LoadTable::EndGroup() {
  readers_.back().RefuseUnknown();
  readers_.pop_back();
}

void LogOptions(const std::vector<std::string>& effective) {
  for (const std::string& line : effective) LogInfo("option " + line);
}

}  // namespace rovio_sfm
