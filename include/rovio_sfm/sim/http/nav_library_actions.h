#pragma once

#include <string>
#include <string_view>

#include "rovio_sfm/sim/http/guarded.h"
#include "rovio_sfm/sim/http/nav_memory.h"
#include "rovio_sfm/sim/http/parameters.h"

namespace rovio_sfm::sim {

// The reply to nav action 25; also what a crossed reply (quirk) looks like.
inline constexpr std::string_view kNavLibraryVersion = "0 | version = 5.13";

// What follows "responses = " for the actions that move nothing: path names (2-11, 21; recorded
// paths are kept by name and never played), tuning (15, 16), parameters (23, 24), version (25).
// Others get code 3 (not implemented) if the robot knows them, else 4.
std::string RunNavLibraryAction(long action, const Parameters& parameters,
                                Guarded<NavMemory>& memory);

}  // namespace rovio_sfm::sim
