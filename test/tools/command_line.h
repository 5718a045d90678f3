#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace rovio_sfm {

// Calls a command as main would, program name included, and returns its status.
template <typename Command>
int RunCommand(const Command& command, std::vector<std::string> arguments, std::string* printed) {
  arguments.insert(arguments.begin(), "program");
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::ostringstream out;
  const int status = command(static_cast<int>(argv.size()), argv.data(), out);
  *printed = out.str();
  return status;
}

}  // namespace rovio_sfm
