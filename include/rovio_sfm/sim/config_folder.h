#pragma once

#include <string>

namespace rovio_sfm::sim {

// The folder that holds worlds/ and tours/: the asked one if not empty; else share/rovio_sfm/config
// beside an installed program; else config/ in a parent of the program or of the working folder.
// Throws std::runtime_error that names where it looked.
std::string FindConfigFolder(const std::string& asked);

}  // namespace rovio_sfm::sim
