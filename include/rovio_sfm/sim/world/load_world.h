#pragma once

#include <string>

#include "rovio_sfm/sim/world/world_spec.h"

namespace rovio_sfm::sim {

// Reads a world's YAML; throws std::runtime_error that names the file, the key and what was
// expected (unknown keys, missing keys and values out of range).
WorldSpec LoadWorld(const std::string& path);

// The same from text; source stands in the messages.
WorldSpec ParseWorld(const std::string& yaml, const std::string& source);

}  // namespace rovio_sfm::sim
