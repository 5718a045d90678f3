#pragma once

#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Writes the options that it sees, with their present values, as YAML with comments. Those that are
// required are left out: no value of them would do.
class YamlTable : public OptionTable {
 public:
  const std::string& Text() const { return text_; }

 private:
  void VisitOption(const OptionRow& row, OptionValue value) override;
  void BeginGroup(const char* name, const char* reason) override;
  void EndGroup() override;

  void AddLine(const std::string& line, const std::string& comment);

  std::string text_;
  size_t depth_ = 0;
};

// Writes the options that it sees as tables of Markdown, one for each group.
class MarkdownTable : public OptionTable {
 public:
  // Groups of these names, at the top, are left out: they stand elsewhere.
  explicit MarkdownTable(std::set<std::string> omitted = {});

  std::string Text() const;

 private:
  struct Line {
    std::string name, value, unit, range, reason;
  };
  struct Section {
    std::string path, reason;
    std::vector<Line> lines;
  };

  void VisitOption(const OptionRow& row, OptionValue value) override;
  void VisitRule(const char* name, bool holds, const char* expected) override;
  void BeginGroup(const char* name, const char* reason) override;
  void EndGroup() override;

  std::set<std::string> omitted_;
  std::vector<Section> sections_;
  std::vector<size_t> open_;  // indices of the groups that are open
};

}  // namespace rovio_sfm
