#include "rovio_sfm/ros/replay.h"

#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <ostream>
#include <stdexcept>

#include "rovio_sfm/app/command_arguments.h"
#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/app/progress_bar.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/ros/bag_images.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

struct Arguments : MappingArguments {
  std::vector<std::string> bags;
  std::string frontend_file, mapper_file;
  SensorOptions sensors;
  StampSource stamps = StampSource::kHeader;
};

void Declare(Arguments* arguments, CLI::App* app) {
  app->add_option("bags", arguments->bags, "bags; each robot of each is a drive")->required();
  app->add_option("--frontend", arguments->frontend_file, "YAML as config/frontend.yaml");
  app->add_option("--mapper", arguments->mapper_file, "YAML as config/mapping.yaml");
  app->add_option("--image-latency", arguments->sensors.image_latency_s,
                  "an image was taken so long before its stamp, s");
  app->add_option("--odom-latency", arguments->sensors.odom_latency_s,
                  "so was an odometry sample, s");
  app->add_option("--stamps", arguments->stamps,
                  "header: messages count as of their header's stamp; bag: as of when they were "
                  "recorded")
      ->transform(CLI::CheckedTransformer(std::map<std::string, StampSource>{
          {"header", StampSource::kHeader}, {"bag", StampSource::kBag}}));
  DeclareMappingArguments(app, arguments);
}

template <typename Options>
void LoadFile(const std::string& path, Options* options) {
  if (path.empty()) return;
  try {
    LoadOptions(YAML::LoadFile(path), "", options);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

// Files first, then what the command line says.
void CompleteOptions(Arguments* arguments) {
  LoadFile(arguments->frontend_file, &arguments->mapper.frontend);
  LoadFile(arguments->mapper_file, &arguments->mapper.mapper);
  CompleteMappingArguments(arguments);
  RequireValid(arguments->sensors);
}

std::shared_ptr<const MapSnapshot> MapBags(const Arguments& arguments, std::ostream& out,
                                           std::ostream& progress) {
  std::vector<std::filesystem::path> paths(arguments.bags.begin(), arguments.bags.end());
  const std::unique_ptr<StoreFolder> store = OpenResultStore(arguments);
  OfflineMapper mapper(arguments.mapper, ReadPlaceModel(arguments.places), nullptr,
                       store ? &store->store() : nullptr);
  for (BagDrive drive : FindDrives(paths)) {
    drive.stamps = arguments.stamps;
    BagImages images(drive, arguments.sensors);
    ProgressBar bar(images.Count(), &progress);
    const double start_s = SteadySeconds();
    mapper.StartDrive(drive.robot);
    size_t num_done = 0;
    while (std::optional<ImageEvent> image = images.Next()) {
      mapper.Add(std::move(*image));
      bar.Show(++num_done, SteadySeconds() - start_s);
    }
    bar.Finish(SteadySeconds() - start_s);
    out << drive.bag.string() << ": " << num_done << " images of " << drive.robot << ", "
        << images.NumRefused() << " messages refused\n";
    for (const auto& [reason, count] : images.Refusals()) {
      out << "  " << count << " x " << reason << "\n";
    }
  }
  const std::shared_ptr<const MapSnapshot> snapshot = mapper.Finish();
  out << mapper.mapper_counters().global_adjustments << " global adjustments\n";
  TellStore(store.get(), out);
  return snapshot;
}

}  // namespace

int ReplayCommand(int argc, const char* const* argv, std::ostream& out, std::ostream& progress) {
  CLI::App app("Maps bags of image_raw/compressed, camera_info, odom and tf, without a ROS master");
  Arguments arguments;
  Declare(&arguments, &app);
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  cv::setNumThreads(1);  // the threads are ours
  CompleteOptions(&arguments);
  PrepareResultFolder(arguments, "cloud.ply");
  const std::shared_ptr<const MapSnapshot> snapshot = MapBags(arguments, out, progress);
  const std::optional<LevelMap> map = FindLargestMap(*snapshot);
  if (!map) throw std::runtime_error("no session could start: nothing to write");
  const Overwrite overwrite = MayReplaceResults(arguments);
  out << snapshot->sessions.size() << " sessions; " << PosedImages(*map).size()
      << " images posed in the largest map, in " << (map->scale ? "metres" : "map units") << "\n";
  for (const auto& path : WriteMapFiles(*map, arguments.out, overwrite)) {
    out << "wrote " << path.string() << "\n";
  }
  return 0;
}

}  // namespace rovio_sfm
