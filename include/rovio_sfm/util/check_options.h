#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Collects the first complaint about the options it sees: "group.name = value: expected 1 to 5".
class CheckTable : public OptionTable {
 public:
  // `group` is the name of all that is checked; may be empty.
  explicit CheckTable(const std::string& group);

  const std::string& FirstComplaint() const { return complaint_; }  // empty: all is well

 private:
  void VisitOption(const OptionRow& row, OptionValue value) override;
  void VisitRule(const char* name, bool holds, const char* expected) override;
  void BeginGroup(const char* name, const char* reason) override;
  void EndGroup() override;

  void ComplainAbout(const std::string& name, const std::string& expected);

  std::vector<std::string> groups_;           // path of each open one, "" or with a point behind
  std::map<std::string, std::string> texts_;  // the values seen, by path
  std::string complaint_;
};

// The first option that does not fit, its value and what was expected; empty if all do.
template <typename Options>
std::string FirstComplaint(Options options, const std::string& group = "") {
  CheckTable table(group);
  options.DescribeOptions(table);
  return table.FirstComplaint();
}

// Whether FirstComplaint has none; else `error`, which may be null, gets it.
template <typename Options>
bool IsValid(const Options& options, std::string* error = nullptr) {
  const std::string complaint = FirstComplaint(options);
  if (error != nullptr && !complaint.empty()) *error = complaint;
  return complaint.empty();
}

// Throws std::runtime_error with the first complaint.
template <typename Options>
void RequireValid(const Options& options, const std::string& group = "") {
  const std::string complaint = FirstComplaint(options, group);
  if (!complaint.empty()) throw std::runtime_error(complaint);
}

}  // namespace rovio_sfm
