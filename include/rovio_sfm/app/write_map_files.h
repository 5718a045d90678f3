#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/merging/localizer.h"
#include "rovio_sfm/report/level_map.h"

namespace rovio_sfm {

// A TUM trajectory of every registered image of a map, one drive after the other.
std::string MapTrajectoryText(const LevelMap& map);

// A PLY of the landmarks that count.
std::string MapCloudBytes(const LevelMap& map);

// Writes trajectory.txt, trajectory_ROBOT.txt for each of several drives (of a robot with several,
// trajectory_DRIVE.txt, see DriveId::ToString), and cloud.ply into a folder that exists; returns
// the absolute paths. Throws std::runtime_error where a file cannot be written.
std::vector<std::filesystem::path> WriteMapFiles(const LevelMap& map,
                                                 const std::filesystem::path& folder,
                                                 Overwrite overwrite);

// The poses of localized images in the level frames of their maps, by stamp, as a TUM trajectory.
std::string LocalizedText(const MapSnapshot& snapshot,
                          const std::map<FrameId, Localization>& localizations);

}  // namespace rovio_sfm
