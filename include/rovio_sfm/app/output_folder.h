#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rovio_sfm {

// Where results go by default, and what ~ stands for.
struct OutputPlace {
  std::string home;      // of the user
  std::string ros_home;  // ROS_HOME; empty: ~/.ros
  std::string date;      // of the run, fit for a folder's name
};

// From the environment and the clock.
OutputPlace CurrentOutputPlace();

// The folder that a parameter of a node means: absolute or below ~, empty for a dated one that is
// not there yet below $ROS_HOME/rovio_sfm. Throws std::runtime_error for anything else: a node's
// working folder is seldom where its user stands. `parameter` is the name for people.
std::filesystem::path NodeOutputFolder(const std::string& parameter, const std::string& value,
                                       const OutputPlace& place);

// Makes the folder and proves that it can be written to and has room for so many bytes. Throws
// std::runtime_error that names the folder.
void RequireWritableFolder(const std::filesystem::path& folder, uintmax_t num_bytes);

}  // namespace rovio_sfm
