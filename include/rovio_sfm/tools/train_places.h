#pragma once

#include <iosfwd>

namespace rovio_sfm {

// The command train_places: learns a place model from photographs and writes it, with progress and
// the time left; an interrupted run goes on with --resume. Returns the exit status; throws
// std::runtime_error for what cannot be read or written.
int TrainPlacesCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
