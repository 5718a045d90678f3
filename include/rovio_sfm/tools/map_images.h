#pragma once

#include <iosfwd>

namespace rovio_sfm {

// The command map_images: maps each folder of images as a drive and writes summary.json,
// trajectory.txt and cloud.ply. Returns the exit status; throws std::runtime_error for what cannot
// be read or written.
int MapImagesCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
