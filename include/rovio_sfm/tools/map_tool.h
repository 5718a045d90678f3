#pragma once

#include <iosfwd>

namespace rovio_sfm {

// The command map_tool: looks at map stores (docs/map_store.md), checks, repairs, prunes, exports
// and merges them. Returns the exit status; throws std::runtime_error for what cannot be read or
// written.
int MapToolCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
