#pragma once

#include <iosfwd>

namespace rovio_sfm {

// The command evaluate_places: recognises the images of query folders among those of database and
// distractor folders, by FAB-MAP before and after geometry and by tf-idf, and writes summary.json,
// curves.csv and answers.csv. Returns the exit status; throws std::runtime_error for what cannot be
// read or written.
int EvaluatePlacesCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
