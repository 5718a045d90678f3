#pragma once

#include <string>

namespace rovio_sfm::sim {

// The folder that holds worlds/ and tours/: the asked one if not empty, else the one that comes
// with the package. Throws std::runtime_error that names where it looked.
std::string FindConfigFolder(const std::string& asked);

}  // namespace rovio_sfm::sim
