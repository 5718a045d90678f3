#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rovio_sfm/app/option_reader.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/option_table.h"

// Options from YAML (files or parameters), as their structs describe them.
namespace rovio_sfm {

// Gives each option that it sees the value that YAML has for it; missing ones keep theirs. Another
// type, a choice that there is not, or an unknown key throws std::runtime_error that names it.
class LoadTable : public OptionTable {
 public:
  explicit LoadTable(const OptionReader& reader) : readers_{reader} {}

  // Refuses what none of the options asked for.
  void EndGroup() override;

 private:
  void VisitOption(const OptionRow& row, OptionValue value) override;
  void BeginGroup(const char* name, const char* reason) override;

  std::vector<OptionReader> readers_;  // one for each open group
};

// Loads and checks; `path` names the whole in messages and may be empty. Returns "path.name =
// value" of every option, as it is now. Throws std::runtime_error that names what does not fit: a
// node then does not start.
template <typename Options>
std::vector<std::string> LoadOptions(const YAML::Node& node, const std::string& path,
                                     Options* options) {
  const OptionReader reader(node, path);
  LoadTable table(reader);
  options->DescribeOptions(table);
  table.EndGroup();
  RequireValid(*options, path);
  return reader.Effective();
}

// Logs what LoadOptions returned.
void LogOptions(const std::vector<std::string>& effective);

}  // namespace rovio_sfm
