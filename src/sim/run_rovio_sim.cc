#include "rovio_sfm/sim/run_rovio_sim.h"

#include <CLI/CLI.hpp>
#include <string>

#include "rovio_sfm/sim/serve.h"

namespace rovio_sfm::sim {
namespace {

struct Arguments {
  std::string images;
  bool repeats = false;
  ServeOptions serve;
};

std::string ListQuirks() {
  std::string text = "NAME=VALUE, a fault of real robots, any number of times; NAME is one of";
  for (const QuirkInfo& info : AllQuirks()) {
    text += "\n  " + std::string(info.name) + ": " + std::string(info.help);
  }
  return text;
}

void AddServeArguments(CLI::App& app, Arguments* arguments) {
  SocketServerOptions& socket = arguments->serve.server.socket;
  app.add_option("--port", socket.port, "TCP port; 0 takes a free one")->default_val(8080);
  app.add_option("--bind", socket.address, "IPv4 address to listen on; 0.0.0.0 for all")
      ->default_val(socket.address);
  app.add_option("--quirk", arguments->serve.quirks, ListQuirks());
}

}  // namespace

int RunRovioSim(int argc, const char* const* argv) {
  Arguments arguments;
  CLI::App app{"A simulated WowWee Rovio"};
  app.add_option("--images", arguments.images, "Serve the images of this folder, in order");
  app.add_flag("--repeat", arguments.repeats, "With --images: begin again after the last");
  AddServeArguments(app, &arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  if (!arguments.images.empty()) {
    return ServeImages(arguments.serve, arguments.images, arguments.repeats);
  }
  std::cerr << app.help();
  return 1;
}

}  // namespace rovio_sfm::sim
