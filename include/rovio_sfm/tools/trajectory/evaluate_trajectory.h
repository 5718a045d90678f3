#pragma once

#include <iosfwd>

namespace rovio_sfm {

// The command evaluate_trajectory: compares TUM trajectories with their ground truth and prints a
// table or JSON. Returns the exit status; throws std::runtime_error for unreadable files.
int EvaluateTrajectoryCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
