#include "rovio_sfm/ros/replay.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/app/command_arguments.h"
#include "rovio_sfm/app/finish_run.h"
#include "rovio_sfm/app/output_folder.h"
#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/app/progress_bar.h"
#include "rovio_sfm/io/calibration.h"
#include "rovio_sfm/ros/bag_images.h"
#include "rovio_sfm/ros/bag_pictures.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/keep_memory.h"
#include "rovio_sfm/util/parse_arguments.h"
#include "rovio_sfm/util/steady_clock.h"
#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {
namespace {

struct Arguments : MappingArguments {
  std::vector<std::string> bags;
  SensorOptions sensors;
  BagTopics topics;
  std::string calibration_file;
  std::optional<Camera> camera;  // of that file
};

void Declare(Arguments* arguments, CLI::App* app) {
  app->add_option("bags", arguments->bags, "bags; each robot of each is a drive")->required();
  app->add_option("--image-latency", arguments->sensors.image_latency_s,
                  "an image was taken so long before its stamp, s");
  app->add_option("--odom-latency", arguments->sensors.odom_latency_s,
                  "so was an odometry sample, s");
  app->add_option("--base-frame", arguments->sensors.base_frame,
                  "tf frame of the body; without: <robot>/base_link");
  app->add_option("--image-topic", arguments->topics.image,
                  "images; without: /<robot>/image_raw/compressed or /<robot>/image_raw");
  app->add_option("--camera-info-topic", arguments->topics.camera_info,
                  "without: beside the images");
  app->add_option("--odom-topic", arguments->topics.odom, "without: /<robot>/odom");
  app->add_option("--calibration", arguments->calibration_file,
                  "camera_info YAML or calibration.txt, instead of a camera_info topic");
  app->add_option("--stamps", arguments->topics.stamps,
                  "header: messages count as of their header's stamp; bag: as of when they were "
                  "recorded")
      ->transform(CLI::CheckedTransformer(std::map<std::string, StampSource>{
          {"header", StampSource::kHeader}, {"bag", StampSource::kBag}}));
  DeclareMappingArguments(app, arguments);
}

std::optional<Camera> ReadCalibration(const std::filesystem::path& path) {
  if (path.empty()) return std::nullopt;
  return ReadCamera(path);
}

void CompleteOptions(Arguments* arguments) {
  CompleteMappingArguments(arguments);
  RequireValid(arguments->sensors);
  arguments->camera = ReadCalibration(arguments->calibration_file);
}

// An older recording may hold what a mapper published beside it.
void TellMapEdges(const BagDrive& drive, const BagImages& images, std::ostream& out) {
  if (images.NumMapEdges() == 0) return;
  out << CountText(images.NumMapEdges(), "transform")
      << " of the map that was made while recording " << drive.bag.string() << " left out\n";
}

// All bags are looked at before the first is mapped.
std::vector<BagDrive> CheckDrives(const Arguments& arguments, size_t* num_images) {
  const std::vector<std::filesystem::path> paths(arguments.bags.begin(), arguments.bags.end());
  std::vector<BagDrive> drives = FindDrives(paths, arguments.topics);
  for (const BagDrive& drive : drives) {
    *num_images += BagImages(drive, arguments.sensors, arguments.camera).Count();
  }
  return drives;
}

void MapDrive(const BagDrive& drive, const Arguments& arguments, OfflineMapper* mapper, MapRun* run,
              std::ostream& out, std::ostream& progress) {
  mapper->StartDrive(drive.robot);
  run->inputs.emplace_back().robot = drive.robot;
  BagImages images(drive, arguments.sensors, arguments.camera);
  ProgressBar bar(images.Count(), &progress);
  const double start_s = SteadySeconds();
  size_t num_done = 0;
  while (!IsStopRequested()) {
    std::optional<ImageEvent> image = images.Next();
    if (!image) break;
    mapper->Add(std::move(*image));
    bar.Show(++num_done, SteadySeconds() - start_s);
  }
  bar.Finish(SteadySeconds() - start_s);
  out << drive.bag.string() << ": " << CountText(num_done, "image") << " of " << drive.robot << ", "
      << CountText(images.NumRefused(), "message") << " refused\n";
  for (const auto& [reason, count] : images.Refusals()) CountReason(reason, &run->left_out, count);
  TellMapEdges(drive, images, out);
  if (const auto why = images.WhyNotMetric()) run->why_no_scale = *why;
}

// What becomes unreadable once others are mapped costs no more than itself.
void MapDrives(const std::vector<BagDrive>& drives, const Arguments& arguments,
               OfflineMapper* mapper, MapRun* run, std::ostream& out, std::ostream& progress) {
  for (const BagDrive& drive : drives) {
    if (IsStopRequested()) return;
    try {
      MapDrive(drive, arguments, mapper, run, out, progress);
    } catch (const std::exception& error) {
      out << "warning: " << drive.bag.string() << ": read no further: " << error.what() << "\n";
      CountReason("bag read no further: " + std::string(error.what()), &run->left_out);
    }
  }
}

nlohmann::ordered_json HeaderOf(const Arguments& arguments) {
  nlohmann::ordered_json header;
  header["bags"] = arguments.bags;
  header["options"] = {{"mode", arguments.mode},
                       {"features", arguments.mapper.frontend.extract.max_features},
                       {"threads", arguments.mapper.num_threads},
                       {"seed", arguments.mapper.seed}};
  return header;
}

int MapBags(const std::vector<BagDrive>& drives, size_t num_images, const Arguments& arguments,
            std::ostream& out, std::ostream& progress) {
  RunToFinish finish;
  finish.start_ns = SteadyNs();
  StageTimes times(SteadyNs);
  const std::shared_ptr<const PlaceModel> places = ReadPlaceModel(arguments.places);
  PrepareMapFolder(arguments, num_images);
  out << "results go to " << std::filesystem::absolute(arguments.out).string() << "\n";
  const std::unique_ptr<StoreFolder> store = OpenResultStore(arguments);
  OfflineMapper mapper(arguments.mapper, places, &times, store ? &store->store() : nullptr);
  finish.run.num_images = num_images;
  MapDrives(drives, arguments, &mapper, &finish.run, out, progress);
  BagPictures pictures(drives, arguments.sensors, arguments.camera);
  finish.pictures = [&](const ModelImage& image) {
    const auto drive = mapper.drives().find(image.id.drive);
    return drive == mapper.drives().end() ? nullptr : pictures.Find(drive->second, image.stamp_ns);
  };
  finish.arguments = &arguments;
  finish.mapper = &mapper;
  finish.times = &times;
  finish.store = store.get();
  return FinishRun(std::move(finish), HeaderOf(arguments), out);
}

}  // namespace

int ReplayCommand(int argc, const char* const* argv, std::ostream& out, std::ostream& progress) {
  CLI::App app("Maps bags of image_raw/compressed, camera_info, odom and tf, without a ROS master");
  Arguments arguments;
  Declare(&arguments, &app);
  app.get_option("--out")->required(false);
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  cv::setNumThreads(1);  // the threads are ours
  KeepFreedMemory();
  CompleteOptions(&arguments);
  if (arguments.out.empty()) {
    arguments.out = NodeOutputFolder("--out", "", CurrentOutputPlace()).string();
  }
  RefuseOlderResults(arguments);
  size_t num_images = 0;
  const std::vector<BagDrive> drives = CheckDrives(arguments, &num_images);
  return MapBags(drives, num_images, arguments, out, progress);
}

}  // namespace rovio_sfm
