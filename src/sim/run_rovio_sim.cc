#include "rovio_sfm/sim/run_rovio_sim.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/sim/config_folder.h"
#include "rovio_sfm/sim/serve.h"
#include "rovio_sfm/sim/serve_simulated_robot.h"
#include "rovio_sfm/sim/tour/audit.h"
#include "rovio_sfm/sim/tour/render_tour.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/parse_arguments.h"

namespace rovio_sfm::sim {
namespace {

// Of a cheap rolling shutter: exposure of a row, and from the first row to the last.
constexpr double kRowShutter_s = 1.0 / 60.0, kReadout_s = 0.030;

struct Arguments {
  std::string camera = "robot";
  double noise_sigma = 10.0;
  std::optional<double> rolling_share;  // else the camera's
  std::string images;
  bool repeats = false;
  bool serves = false;
  std::vector<std::string> audit;  // [world,] tour
  std::string surface;             // tour
  std::string config_folder;
  ServeOptions serve;
  ServeRobotOptions robot;   // tour, seed, noise and shutter of --serve
  RenderTourOptions render;  // of --render
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
  app.add_option("--port", socket.port, "TCP port; 0 takes a free one")
      ->default_val(8080)
      ->check(CLI::Range(0, 65535));
  app.add_option("--bind", socket.address, "IPv4 address to listen on; 0.0.0.0 for all")
      ->default_val(socket.address);
  app.add_option("--quirk", arguments->serve.quirks, ListQuirks());
}

void AddRenderArguments(CLI::App& app, Arguments* arguments) {
  RenderTourOptions& render = arguments->render;
  app.add_option("--render", render.tour, "Render this tour, as fast as it goes, into --out");
  app.add_option("--surface", arguments->surface,
                 "Write what this tour sees of the true surfaces as the PLY file --out");
  app.add_option("--audit", arguments->audit, "[WORLD] TOUR: print the figures that keep it honest")
      ->expected(1, 2);
  app.add_option("--out", render.out_folder, "Folder for the data set of --render");
  app.add_option("--clean-out", render.clean_out_folder,
                 "With --render: the same pictures without noise, into this folder");
  app.add_flag("--overwrite", render.overwrite, "Write over a data set in --out");
  app.add_option("--frames", render.max_frames, "Only the first so many pictures; 0: all");
  app.add_option("--threads", render.num_threads, "Threads of --render")->default_val(1);
  app.add_option("--config", arguments->config_folder, "Folder with worlds/ and tours/");
  app.add_option("--seed", render.seed, "Of everything random")->default_val(1);
  app.add_option(
         "--camera", arguments->camera,
         "robot: lens blur, Bayer sensor, metering, coarse JPEG, rolling shutter, a calibration "
         "that errs; plain: none of these, noise that is each pixel's own")
      ->check(CLI::IsMember({"robot", "plain"}))
      ->default_val(arguments->camera);
  app.add_option("--light", render.light, "Time of day: the world's lights drawn anew; 0: its own")
      ->default_val(render.light);
  app.add_option("--steps", render.steps, "Steps between pictures, times the tour's own")
      ->default_val(render.steps);
  app.add_flag("--movers", render.has_movers, "The people whom the tour's file names walk there");
  app.add_option("--noise", arguments->noise_sigma, "Grey levels after decoding; 0: none")
      ->default_val(arguments->noise_sigma);
  app.add_option("--samples", render.render.samples_per_side, "A pixel has this squared samples")
      ->default_val(render.render.samples_per_side);
  app.add_option("--rolling-shutter", arguments->rolling_share,
                 "Share of the motion between first and last row, 0 … 0.9");
}

void ChooseCamera(Arguments* arguments) {
  const bool is_robot = arguments->camera == "robot";
  RenderTourOptions& render = arguments->render;
  if (is_robot) {
    render.develop = RobotDevelopOptions();
    render.render.rolling_share = kReadout_s / (kRowShutter_s + kReadout_s);
    arguments->robot.shutter_s = kRowShutter_s + kReadout_s;
  }
  render.errs_in_calibration = is_robot;
  render.develop.noise_sigma = arguments->noise_sigma;
  if (arguments->rolling_share) render.render.rolling_share = *arguments->rolling_share;
}

int AuditByArguments(const Arguments& arguments) {
  AuditOptions audit;
  audit.config_folder = FindConfigFolder(arguments.config_folder);
  audit.tour = arguments.audit.back();
  if (arguments.audit.size() == 2) audit.world = arguments.audit.front();
  audit.seed = arguments.render.seed;
  audit.steps = arguments.render.steps;
  audit.render = arguments.render.render;
  audit.develop = arguments.render.develop;
  return PrintAudit(Audit(audit), std::cout) ? 0 : 1;
}

int ServeByArguments(Arguments* arguments) {
  ServeRobotOptions& robot = arguments->robot;
  robot.serve = arguments->serve;
  robot.config_folder = FindConfigFolder(arguments->config_folder);
  robot.seed = arguments->render.seed;
  robot.light = arguments->render.light;
  robot.has_movers = arguments->render.has_movers;
  robot.render = arguments->render.render;
  robot.develop = arguments->render.develop;
  return ServeSimulatedRobot(robot);
}

int SurfaceByArguments(Arguments* arguments) {
  arguments->render.config_folder = FindConfigFolder(arguments->config_folder);
  arguments->render.tour = arguments->surface;
  const size_t count = WriteTourSurface(arguments->render);
  std::cout << CountText(count, "point") << " of " << arguments->surface << " in "
            << std::filesystem::absolute(arguments->render.out_folder).string() << std::endl;
  return 0;
}

int RenderByArguments(Arguments* arguments) {
  arguments->render.config_folder = FindConfigFolder(arguments->config_folder);
  const int count = RenderTour(arguments->render);
  std::cout << CountText(static_cast<uint64_t>(count), "picture") << " of "
            << arguments->render.tour << " in "
            << std::filesystem::absolute(arguments->render.out_folder).string() << std::endl;
  return 0;
}

}  // namespace

int RunRovioSim(int argc, const char* const* argv) {
  Arguments arguments;
  CLI::App app{"A simulated WowWee Rovio"};
  app.add_option("--images", arguments.images, "Serve the images of this folder, in order");
  app.add_flag("--repeat", arguments.repeats, "With --images: begin again after the last");
  app.add_flag("--serve", arguments.serves, "Serve a robot that drives through a world, real time");
  app.add_option("--tour", arguments.robot.tour, "With --serve: world and start of this tour")
      ->default_val("visionlab");
  AddServeArguments(app, &arguments);
  AddRenderArguments(app, &arguments);
  if (const auto status = ParseArguments(&app, argc, argv, std::cout)) return *status;
  ChooseCamera(&arguments);
  if (!arguments.images.empty()) {
    return ServeImages(arguments.serve, arguments.images, arguments.repeats);
  }
  if (!arguments.surface.empty()) return SurfaceByArguments(&arguments);
  if (!arguments.render.tour.empty()) return RenderByArguments(&arguments);
  if (!arguments.audit.empty()) return AuditByArguments(arguments);
  if (arguments.serves) return ServeByArguments(&arguments);
  std::cerr << app.help();
  return 1;
}

}  // namespace rovio_sfm::sim
