#pragma once

#include <string_view>
#include <vector>

#include "rovio_sfm/sim/http/accounts.h"
#include "rovio_sfm/sim/http/parameters.h"
#include "rovio_sfm/sim/http/reply_fields.h"
#include "rovio_sfm/sim/http/server_context.h"

namespace rovio_sfm::sim {

// One command as it arrives: by its own path (/GetStatus.cgi) or by /rev.cgi?Cmd=GetStatus.cgi.
struct CommandCall {
  const Parameters& parameters;
  const Caller& caller;
  ServerContext& context;
};

struct CommandReply {
  ReplyFields fields;
  bool reboots_robot = false;  // once the connection is over
};

struct Command {
  std::string_view name;  // the path without its slash
  Privilege (*level)(const CommandCall&);
  void (*run)(const CommandCall&, CommandReply*);
};

// Null for names that the robot does not know.
const Command* FindCommand(std::string_view name);

// The parts of the table, by topic.
std::vector<Command> CameraCommands();
std::vector<Command> AccountCommands();
std::vector<Command> SystemCommands();
Command NavCommand();

// The usual levels.
Privilege NeedsUser(const CommandCall& call);
Privilege NeedsAdmin(const CommandCall& call);

}  // namespace rovio_sfm::sim
