#include "rovio_sfm/app/option_pages.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/util/option_text.h"

namespace rovio_sfm {
namespace {

constexpr size_t kCommentColumn = 30;

std::string JoinTexts(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

// "<robot>" would be taken for a tag.
std::string EscapeTags(std::string text) {
  for (size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 2)) {
    text.insert(at, "\\");
  }
  return text;
}

}  // namespace

void YamlTable::VisitOption(const OptionRow& row, OptionValue value) {
  if (row.use == OptionUse::kRequired) return;
  const std::string choices = row.choices.empty() ? "" : RangeText(row);
  AddLine(row.name + std::string(": ") + YamlTextOf(value), JoinTexts(choices, row.reason));
}

void YamlTable::BeginGroup(const char* name, const char* reason) {
  AddLine(name + std::string(":"), reason);
  ++depth_;
}

void YamlTable::EndGroup() { --depth_; }

void YamlTable::AddLine(const std::string& line, const std::string& comment) {
  std::string whole = std::string(2 * depth_, ' ') + line;
  if (!comment.empty()) {
    whole.resize(std::max(whole.size() + 2, kCommentColumn), ' ');
    whole += "# " + comment;
  }
  text_ += whole + "\n";
}

MarkdownTable::MarkdownTable(std::set<std::string> omitted)
    : omitted_(std::move(omitted)), sections_(1), open_{0} {}

void MarkdownTable::VisitOption(const OptionRow& row, OptionValue value) {
  std::string reason = row.reason;
  if (row.use == OptionUse::kLive) reason = JoinTexts(reason, "**live**");
  if (row.use == OptionUse::kRequired) reason = JoinTexts(reason, "**must be set**");
  sections_[open_.back()].lines.push_back(
      {row.name, TextOf(value), UnitOf(row.name), RangeText(row), EscapeTags(reason)});
}

void MarkdownTable::VisitRule(const char* name, bool /*holds*/, const char* expected) {
  const std::string path = sections_[open_.back()].path;
  const std::string wanted = (path.empty() ? "" : path + ".") + name;
  for (Section& section : sections_) {
    for (Line& line : section.lines) {
      const std::string found = (section.path.empty() ? "" : section.path + ".") + line.name;
      if (found == wanted) line.range = JoinTexts(line.range, expected);
    }
  }
}

void MarkdownTable::BeginGroup(const char* name, const char* reason) {
  const std::string& above = sections_[open_.back()].path;
  sections_.push_back({(above.empty() ? "" : above + ".") + name, reason, {}});
  open_.push_back(sections_.size() - 1);
}

void MarkdownTable::EndGroup() { open_.pop_back(); }

std::string MarkdownTable::Text() const {
  std::string text;
  for (const Section& section : sections_) {
    const bool is_omitted = omitted_.count(section.path.substr(0, section.path.find('.'))) > 0;
    if (is_omitted || section.lines.empty()) continue;
    if (!section.path.empty()) text += "\n`" + section.path + "`";
    if (!section.reason.empty()) text += ": " + section.reason;
    if (!section.path.empty()) text += "\n";
    text += "\n| option | default | unit | range | what it is |\n|---|---|---|---|---|\n";
    for (const Line& line : section.lines) {
      text += "| `" + line.name + "` | " + line.value + " | " + line.unit + " | " + line.range +
              " | " + line.reason + " |\n";
    }
  }
  return text;
}

}  // namespace rovio_sfm
