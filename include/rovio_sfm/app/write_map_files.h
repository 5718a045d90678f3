#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/app/write_model_files.h"
#include "rovio_sfm/io/named_file.h"
#include "rovio_sfm/merging/localizer.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/report/page_data.h"

namespace rovio_sfm {

// A TUM trajectory of a map by rising stamp. Where images of several drives have one stamp, which
// no tool could tell apart, only the first drive's is in it, which it says; the files of the drives
// hold all.
std::string MapTrajectoryText(const LevelMap& map);

// A PLY of the landmarks that count.
std::string MapCloudBytes(const LevelMap& map);

// Where the map of this rank by size is written: the folder itself, map_2, map_3 and so on in it.
std::filesystem::path FolderOfMap(const std::filesystem::path& folder, size_t rank);

// Throws std::runtime_error where a file cannot be written.
WrittenFiles WriteFiles(const std::vector<NamedFile>& files, const std::filesystem::path& folder,
                        Overwrite overwrite);

// What formats that need more than the map itself ask for; may be empty where none does.
struct MapSource {
  std::function<MapModel(const LevelMap&)> model_of;
  PictureSource pictures;
  PageNotes notes;             // of the report
  ReadFeatures features = {};  // with descriptors, to densify
};

// Throws std::runtime_error naming the first file or folder of these formats that is there already.
void RequireNoFiles(const std::filesystem::path& folder, const MapFormats& formats);

// Writes the map into a folder that exists, in each of the formats: trajectory.txt and, for each of
// several drives, trajectory_DRIVE.txt (see DriveNames); cloud.ply; kitti/DRIVE_poses.txt and
// _times.txt; and what WriteModelFiles says. Unless overwriting is allowed nothing is written where
// RequireNoFiles throws. Throws std::runtime_error where a file cannot be written.
WrittenFiles WriteMapFiles(const LevelMap& map, const MapSource& source, const MapFormats& formats,
                           const std::filesystem::path& folder, Overwrite overwrite);

// The same in the default formats.
inline std::vector<std::filesystem::path> WriteMapFiles(const LevelMap& map,
                                                        const std::filesystem::path& folder,
                                                        Overwrite overwrite) {
  return WriteMapFiles(map, {}, kDefaultFormats, folder, overwrite).paths;
}

// "wrote PATH" a line, and how many pictures were not at hand.
void PrintWritten(const WrittenFiles& written, std::ostream& out);

// The poses of localized images in the level frames of their maps, as TUM trajectories by stamp:
// localized.txt and, for each of several drives, localized_DRIVE.txt, beside the map's own files.
std::vector<NamedFile> LocalizedFiles(const MapSnapshot& snapshot,
                                      const std::map<FrameId, Localization>& localizations);
// What runs have listed in the folder of maps, without such files.
std::vector<std::filesystem::path> ListedMapFiles(const std::filesystem::path& folder);

}  // namespace rovio_sfm
