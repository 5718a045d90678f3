#pragma once

#include <iosfwd>

namespace rovio_sfm {

// The command replay: maps bags without a ROS master, each robot of each bag as a drive, and writes
// all maps and summary.json, by default into a dated folder below $ROS_HOME. The same bags, options
// and seed give the same bytes, whatever the number of threads. Progress goes to `progress`.
// Returns the exit status; throws std::runtime_error for what cannot be read or written.
int ReplayCommand(int argc, const char* const* argv, std::ostream& out, std::ostream& progress);

}  // namespace rovio_sfm
