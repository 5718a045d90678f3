#include "rovio_sfm/sim/http/command.h"

#include <algorithm>

namespace rovio_sfm::sim {
namespace {

std::vector<Command> AllCommands() {
  std::vector<Command> all = {NavCommand()};
  for (const auto& part : {CameraCommands(), AccountCommands(), SystemCommands()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace

const Command* FindCommand(std::string_view name) {
  static const std::vector<Command> all = AllCommands();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [name](const Command& command) { return command.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Privilege NeedsUser(const CommandCall&) { return Privilege::kUser; }
Privilege NeedsAdmin(const CommandCall&) { return Privilege::kAdmin; }

}  // namespace rovio_sfm::sim
