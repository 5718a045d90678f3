#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/report/level_map.h"

namespace rovio_sfm {

// A TUM trajectory of a map by rising stamp. Where images of several drives have one stamp, which
// no tool could tell apart, only the first drive's is in it; the files of the drives hold all.
std::string MapTrajectoryText(const LevelMap& map);

// A PLY of the landmarks that count.
std::string MapCloudBytes(const LevelMap& map);

// Writes trajectory.txt, trajectory_ROBOT.txt for each of several drives (of a robot with several,
// trajectory_DRIVE.txt, see DriveId::ToString), and cloud.ply into a folder that exists; returns
// the absolute paths. Throws std::runtime_error where a file cannot be written.
std::vector<std::filesystem::path> WriteMapFiles(const LevelMap& map,
                                                 const std::filesystem::path& folder,
                                                 Overwrite overwrite);

}  // namespace rovio_sfm
