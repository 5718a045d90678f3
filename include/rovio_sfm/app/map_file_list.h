#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rovio_sfm {

// A folder of results knows what runs have written into it, so that a later one removes that and
// nothing else: map_files.txt holds a path a line, relative to the folder. What a line says of
// another place, by ".." or through a link, is passed over.
constexpr char kMapFileList[] = "map_files.txt";

// Those that are there, absolute, sorted; none where there is no list.
std::vector<std::filesystem::path> ListedFiles(const std::filesystem::path& folder);

// Puts files below the folder on its list. Throws std::runtime_error where it cannot be written.
void AddListedFiles(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files);

// Removes what is listed but not among the fresh ones, with folders that this empties; the list is
// the fresh ones then. Throws std::runtime_error where it cannot be written.
void RemoveListedBut(const std::filesystem::path& folder,
                     const std::vector<std::filesystem::path>& fresh);

}  // namespace rovio_sfm
