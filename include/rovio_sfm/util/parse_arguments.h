#pragma once

#include <iosfwd>
#include <optional>

namespace CLI {
class App;
}

namespace rovio_sfm {

// Reads the command line into what was declared. The exit status if the program ends here because
// out now holds the help that was asked for. Numbers are decimal and finite; whole ones never wrap
// round. Throws std::runtime_error that names the option, its value and what was expected.
std::optional<int> ParseArguments(CLI::App* app, int argc, const char* const* argv,
                                  std::ostream& out);

}  // namespace rovio_sfm
