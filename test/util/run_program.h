#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace rovio_sfm {

// Runs a shell command line and returns what it prints, errors too; the test fails where the
// program does. Programs of others that read what we write: scripts/install_dependencies --peers.
inline std::string RunProgram(const std::string& command) {
  std::string printed;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    ADD_FAILURE() << "popen failed for " << command;
    return printed;
  }
  char buffer[4096];
  for (size_t count = 0; (count = fread(buffer, 1, sizeof(buffer), pipe)) > 0;) {
    printed.append(buffer, count);
  }
  const int status = pclose(pipe);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command << "\n" << printed;
  return printed;
}

// The number that follows a name in a program's output, as COLMAP prints its figures.
inline double FigureAfter(const std::string& name, const std::string& printed) {
  const size_t at = printed.find(name);
  if (at == std::string::npos) {
    ADD_FAILURE() << "no \"" << name << "\" in\n" << printed;
    return 0.0;
  }
  const size_t number = printed.find_first_of("-0123456789", at + name.size());
  return std::stod(printed.substr(number));
}

}  // namespace rovio_sfm
