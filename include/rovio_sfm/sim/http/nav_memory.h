#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rovio_sfm::sim {

// What the navigation library keeps in flash: parameters, tuning, names of paths. The simulated
// robot does not drive recorded paths; it only keeps their names.
struct NavMemory {
  static constexpr size_t kNumParameters = 20;

  std::array<int32_t, kNumParameters> parameters{};
  // Units and real defaults are unknown; order as the robot prints it.
  std::vector<std::pair<std::string, long>> tuning = {
      {"LeftRight", 5},  {"Forward", 5},  {"Reverse", 5}, {"DriveTurn", 5},
      {"HomingTurn", 5}, {"ManDrive", 5}, {"ManTurn", 5}, {"DockTimeout", 60}};
  std::vector<std::string> paths;
  bool is_recording = false;
};

}  // namespace rovio_sfm::sim
