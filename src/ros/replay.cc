#include "rovio_sfm/ros/replay.h"

#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "rovio_sfm/app/command_arguments.h"
#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/app/progress_bar.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/io/calibration.h"
#include "rovio_sfm/ros/bag_images.h"
#include "rovio_sfm/ros/bag_pictures.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

struct Arguments : MappingArguments {
  std::vector<std::string> bags;
  std::string frontend_file, mapper_file;
  SensorOptions sensors;
  BagTopics topics;
  std::string calibration_file;
  std::optional<Camera> camera;  // of that file
};

void Declare(Arguments* arguments, CLI::App* app) {
  app->add_option("bags", arguments->bags, "bags; each robot of each is a drive")->required();
  app->add_option("--frontend", arguments->frontend_file, "YAML as config/frontend.yaml");
  app->add_option("--mapper", arguments->mapper_file, "YAML as config/mapping.yaml");
  app->add_option("--image-latency", arguments->sensors.image_latency_s,
                  "an image was taken so long before its stamp, s");
  app->add_option("--odom-latency", arguments->sensors.odom_latency_s,
                  "so was an odometry sample, s");
  app->add_option("--base-frame", arguments->sensors.base_frame,
                  "tf frame of the robot's body; <robot>/base_link if not given");
  app->add_option("--image-topic", arguments->topics.image,
                  "the images to map; /<robot>/image_raw[/compressed] of all robots if not given");
  app->add_option("--camera-info-topic", arguments->topics.camera_info,
                  "camera_info beside the images if not given");
  app->add_option("--odom-topic", arguments->topics.odom, "/<robot>/odom if not given");
  app->add_option("--calibration", arguments->calibration_file,
                  "instead of camera_info: calibration.txt, or camera_info as .yaml");
  app->add_option("--stamps", arguments->topics.stamps,
                  "header: messages count as of their header's stamp; bag: as of when they were "
                  "recorded")
      ->transform(CLI::CheckedTransformer(std::map<std::string, StampSource>{
          {"header", StampSource::kHeader}, {"bag", StampSource::kBag}}));
  DeclareMappingArguments(app, arguments);
}

std::optional<Camera> ReadCalibration(const std::filesystem::path& path) {
  if (path.empty()) return std::nullopt;
  const bool is_yaml = path.extension() == ".yaml" || path.extension() == ".yml";
  return is_yaml ? ReadCameraInfo(path) : ReadCalibrationText(path);
}

// What a reader of the result should know of its drive.
void TellDrive(const BagDrive& drive, const BagImages& images, std::ostream& out) {
  if (images.NumMapEdges() > 0) {
    out << images.NumMapEdges() << " transforms of the map that was made while recording "
        << drive.bag.string() << " left out\n";
  }
  if (const auto reason = images.WhyNotMetric()) {
    out << drive.robot << ": not in metres: " << *reason << "\n";
  }
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
  arguments->camera = ReadCalibration(arguments->calibration_file);
}

std::shared_ptr<const MapSnapshot> MapBags(const std::vector<BagDrive>& drives,
                                           const Arguments& arguments, OfflineMapper* mapper,
                                           std::ostream& out, std::ostream& progress) {
  for (const BagDrive& drive : drives) {
    BagImages images(drive, arguments.sensors, arguments.camera);
    ProgressBar bar(images.Count(), &progress);
    const double start_s = SteadySeconds();
    mapper->StartDrive(drive.robot);
    size_t num_done = 0;
    while (std::optional<ImageEvent> image = images.Next()) {
      mapper->Add(std::move(*image));
      bar.Show(++num_done, SteadySeconds() - start_s);
    }
    bar.Finish(SteadySeconds() - start_s);
    out << drive.bag.string() << ": " << num_done << " images of " << drive.robot << ", "
        << images.NumRefused() << " messages refused\n";
    TellDrive(drive, images, out);
    for (const auto& [reason, count] : images.Refusals()) {
      out << "  " << count << " x " << reason << "\n";
    }
  }
  const std::shared_ptr<const MapSnapshot> snapshot = mapper->Finish();
  out << mapper->mapper_counters().global_adjustments << " global adjustments\n";
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
  const std::vector<BagDrive> drives = FindDrives({arguments.bags.begin(), arguments.bags.end()}, arguments.topics);
  const std::unique_ptr<StoreFolder> store = OpenResultStore(arguments);
  OfflineMapper mapper(arguments.mapper, ReadPlaceModel(arguments.places), nullptr,
                       store ? &store->store() : nullptr);
  const auto snapshot = MapBags(drives, arguments, &mapper, out, progress);
  TellStore(store.get(), out);
  if (arguments.mapper.localize) return WriteLocalized(mapper, *snapshot, arguments, out);
  const std::optional<LevelMap> map = FindLargestMap(*snapshot);
  if (!map) throw std::runtime_error("no session could start: nothing to write");
  const Overwrite overwrite = MayReplaceResults(arguments);
  out << snapshot->sessions.size() << " sessions; " << PosedImages(*map).size()
      << " images posed in the largest map, in " << (map->scale ? "metres" : "map units") << "\n";
  BagPictures pictures(drives, arguments.sensors);
  const MapSource source{
      [&](const LevelMap& level_map) { return mapper.ModelOf(level_map); },
      [&](const ModelImage& image) { return pictures.Find(image.id.drive.robot, image.stamp_ns); }};
  PrintWritten(WriteMapFiles(*map, source, arguments.formats, arguments.out, overwrite), out);
  return 0;
}

}  // namespace rovio_sfm
