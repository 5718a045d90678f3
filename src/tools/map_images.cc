#include "rovio_sfm/tools/map_images.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/app/command_arguments.h"
#include "rovio_sfm/app/finish_run.h"
#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/io/dataset_folder.h"
#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/util/keep_memory.h"
#include "rovio_sfm/util/parse_arguments.h"
#include "rovio_sfm/util/steady_clock.h"
#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxImageBytes = 64u << 20;

struct Arguments : MappingArguments {
  std::vector<std::string> folders;
  size_t stride = 1;
  bool without_odometry = false;
};

void Declare(Arguments* arguments, CLI::App* app) {
  app->add_option("folders", arguments->folders, "folders of images, each one a drive")->required();
  app->add_option("--stride", arguments->stride, "use every N-th image")
      ->check(CLI::Range(1, 1000000));
  app->add_flag("--without-odometry", arguments->without_odometry, "map from the images alone");
  DeclareMappingArguments(app, arguments);
}

std::vector<DatasetFolder> ReadFolders(const Arguments& arguments) {
  std::vector<DatasetFolder> datasets;
  for (const std::string& folder : arguments.folders) {
    datasets.push_back(EveryNth(ReadDatasetFolder(folder), arguments.stride));
  }
  return datasets;
}

ImageEvent ReadImage(const DatasetFolder& dataset, const DatasetImage& image, bool with_odometry) {
  ImageEvent event;
  event.stamp_ns = image.stamp_ns;
  event.name = image.name;
  event.encoded =
      std::make_shared<const std::vector<uint8_t>>(ReadBytes(image.path, kMaxImageBytes));
  event.camera = dataset.camera;
  event.base_from_camera = image.base_from_camera;
  if (with_odometry) event.odometry = image.odometry;
  return event;
}

YawByStamp YawsOf(const DatasetFolder& dataset) {
  YawByStamp yaws;
  for (const DatasetImage& image : dataset.images) {
    if (image.odometry) yaws[image.stamp_ns] = image.odometry->yaw_rad;
  }
  return yaws;
}

DriveInput InputOf(const DatasetFolder& dataset, const std::string& robot, bool with_odometry) {
  DriveInput input;
  input.robot = robot;
  for (const DatasetImage& image : dataset.images) input.image_names.push_back(image.name);
  input.ground_truth = dataset.ground_truth;
  if (with_odometry) input.odometry = YawsOf(dataset);
  return input;
}

std::string RobotOf(size_t folder) { return "folder_" + std::to_string(folder); }

// The picture of a frame: the file of its folder with the same stamp.
std::shared_ptr<const std::vector<uint8_t>> FindPicture(const std::vector<DatasetFolder>& datasets,
                                                        const OfflineMapper& mapper,
                                                        const ModelImage& wanted) {
  const auto folder = mapper.drives().find(wanted.id.drive);
  if (folder == mapper.drives().end()) return nullptr;  // of an earlier run
  for (const DatasetImage& image : datasets[folder->second].images) {
    if (image.stamp_ns != wanted.stamp_ns) continue;
    return std::make_shared<const std::vector<uint8_t>>(ReadBytes(image.path, kMaxImageBytes));
  }
  return nullptr;
}

size_t CountImages(const std::vector<DatasetFolder>& datasets) {
  size_t num_images = 0;
  for (const DatasetFolder& dataset : datasets) num_images += dataset.images.size();
  return num_images;
}

// An image that cannot be read costs that image alone.
void MapFolder(const DatasetFolder& dataset, bool with_odometry, OfflineMapper* mapper,
               ReasonCounts* left_out) {
  for (const DatasetImage& image : dataset.images) {
    if (IsStopRequested()) return;
    std::optional<ImageEvent> event;
    try {
      event = ReadImage(dataset, image, with_odometry);
    } catch (const std::runtime_error& error) {
      CountReason(error.what(), left_out);
    }
    if (event) mapper->Add(std::move(*event));
  }
}

MapRun MapFolders(const std::vector<DatasetFolder>& datasets, const Arguments& arguments,
                  OfflineMapper* mapper) {
  MapRun run;
  run.num_images = CountImages(datasets);
  for (size_t i = 0; i < datasets.size() && !IsStopRequested(); ++i) {
    run.inputs.push_back(InputOf(datasets[i], RobotOf(i), !arguments.without_odometry));
    mapper->StartDrive(run.inputs.back().robot);
    MapFolder(datasets[i], !arguments.without_odometry, mapper, &run.left_out);
  }
  return run;
}

nlohmann::ordered_json HeaderOf(const Arguments& arguments) {
  nlohmann::ordered_json header;
  header["folders"] = arguments.folders;
  header["options"] = {{"stride", arguments.stride},
                       {"mode", arguments.mode},
                       {"features", arguments.mapper.frontend.extract.max_features},
                       {"threads", arguments.mapper.num_threads},
                       {"seed", arguments.mapper.seed}};
  return header;
}

int MapAll(const std::vector<DatasetFolder>& datasets, const Arguments& arguments,
           std::ostream& out) {
  RunToFinish finish;
  finish.start_ns = SteadyNs();
  StageTimes times(SteadyNs);
  const std::shared_ptr<const PlaceModel> places = ReadPlaceModel(arguments.places);
  PrepareMapFolder(arguments, CountImages(datasets));
  const std::unique_ptr<StoreFolder> store = OpenResultStore(arguments);
  OfflineMapper mapper(arguments.mapper, places, &times, store ? &store->store() : nullptr);
  finish.run = MapFolders(datasets, arguments, &mapper);
  finish.pictures = [&](const ModelImage& image) { return FindPicture(datasets, mapper, image); };
  finish.arguments = &arguments;
  finish.mapper = &mapper;
  finish.times = &times;
  finish.store = store.get();
  return FinishRun(std::move(finish), HeaderOf(arguments), out);
}

}  // namespace

int MapImagesCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Maps folders of images (data-set layout), each one as a drive, without ROS");
  Arguments arguments;
  arguments.mode = "every";
  Declare(&arguments, &app);
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  cv::setNumThreads(1);  // the threads are ours
  KeepFreedMemory();
  CompleteMappingArguments(&arguments);
  RefuseOlderResults(arguments);
  const std::vector<DatasetFolder> datasets = ReadFolders(arguments);
  return MapAll(datasets, arguments, out);
}

}  // namespace rovio_sfm
