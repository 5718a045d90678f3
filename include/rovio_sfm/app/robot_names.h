#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/util/option_table.h"

// Options that name robots, whose topics and frames bear these names.
namespace rovio_sfm {

inline void AddRobotName(OptionTable& table, std::string& robot, const char* reason) {
  std::string error;
  table.AddText("robot", robot, reason);
  table.AddRule("robot", IsValidRobotName(robot, &error),
                "1 to 32 characters a-z, 0-9 or _, beginning with a letter");
}

inline void AddRobotNames(OptionTable& table, std::vector<std::string>& robots,
                          const char* reason) {
  std::string error;
  const bool are_names = std::all_of(robots.begin(), robots.end(), [&](const std::string& robot) {
    return IsValidRobotName(robot, &error);
  });
  table.AddTexts("robots", robots, reason);
  const bool are_different =
      std::set<std::string>(robots.begin(), robots.end()).size() == robots.size();
  table.AddRule(
      "robots", are_names && are_different && !robots.empty() && robots.size() <= 32,
      "1 to 32 different names of 1 to 32 characters a-z, 0-9 or _, each beginning with a letter");
}

}  // namespace rovio_sfm
