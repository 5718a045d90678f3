#include "rovio_sfm/tools/map_images.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <ostream>

#include "rovio_sfm/app/command_arguments.h"
#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/io/dataset_folder.h"
#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/tools/map_summary.h"
#include "rovio_sfm/util/steady_clock.h"

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

std::string RobotOf(size_t folder) { return "folder_" + std::to_string(folder); }

// The picture of a frame: the file of its folder with the same stamp.
std::shared_ptr<const std::vector<uint8_t>> FindPicture(const std::vector<DatasetFolder>& datasets,
                                                        const ModelImage& wanted) {
  for (size_t i = 0; i < datasets.size(); ++i) {
    if (RobotOf(i) != wanted.id.drive.robot) continue;
    for (const DatasetImage& image : datasets[i].images) {
      if (image.stamp_ns != wanted.stamp_ns) continue;
      return std::make_shared<const std::vector<uint8_t>>(ReadBytes(image.path, kMaxImageBytes));
    }
  }
  return nullptr;
}

MapRun MapFolders(const std::vector<DatasetFolder>& datasets, const Arguments& arguments,
                  StageTimes* times, OfflineMapper* mapper) {
  const int64_t start_ns = SteadyNs();
  MapRun run;
  for (size_t i = 0; i < datasets.size(); ++i) {
    const std::string robot = RobotOf(i);
    mapper->StartDrive(robot);
    for (const DatasetImage& image : datasets[i].images) {
      mapper->Add(ReadImage(datasets[i], image, !arguments.without_odometry));
    }
    run.num_images += datasets[i].images.size();
    if (!arguments.without_odometry) run.odometry[robot] = YawsOf(datasets[i]);
    if (!datasets[i].ground_truth.empty()) run.ground_truth[robot] = datasets[i].ground_truth;
  }
  run.snapshot = mapper->Finish();
  run.frontend = mapper->frontend_counters();
  run.funnel = mapper->matching_funnel();
  run.mapper = mapper->mapper_counters();
  run.merges = mapper->merge_reports();
  run.stages = times->totals();
  run.wall_s = 1e-9 * static_cast<double>(SteadyNs() - start_ns);
  run.peak_rss_mb = PeakRssMb();
  return run;
}

void WriteResults(const MapRun& run, const MapSource& source, const Arguments& arguments,
                  std::ostream& out) {
  const Overwrite overwrite = MayReplaceResults(arguments);
  nlohmann::ordered_json summary;
  summary["folders"] = arguments.folders;
  summary["options"] = {{"stride", arguments.stride},
                        {"mode", arguments.mode},
                        {"features", arguments.mapper.frontend.extract.max_features},
                        {"threads", arguments.mapper.num_threads},
                        {"seed", arguments.mapper.seed}};
  summary.update(MapSummaryJson(run));
  if (const auto map = FindLargestMap(*run.snapshot)) {
    PrintWritten(WriteMapFiles(*map, source, arguments.formats, arguments.out, overwrite), out);
  }
  const std::filesystem::path path = std::filesystem::path(arguments.out) / "summary.json";
  WriteFile(path, summary.dump(2) + "\n", overwrite);
  out << "wrote " << std::filesystem::absolute(path).string() << "\n" << summary.dump(2) << "\n";
}

}  // namespace

int MapImagesCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Maps folders of images (data-set layout), each one as a drive, without ROS");
  Arguments arguments;
  arguments.mode = "every";
  Declare(&arguments, &app);
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  cv::setNumThreads(1);  // the threads are ours
  CompleteMappingArguments(&arguments);
  PrepareResultFolder(arguments, "summary.json");
  const std::vector<DatasetFolder> datasets = ReadFolders(arguments);
  StageTimes times(SteadyNs);
  const std::unique_ptr<StoreFolder> store = OpenResultStore(arguments);
  OfflineMapper mapper(arguments.mapper, ReadPlaceModel(arguments.places), &times,
                       store ? &store->store() : nullptr);
  const MapRun run = MapFolders(datasets, arguments, &times, &mapper);
  TellStore(store.get(), out);
  if (arguments.mapper.localize) return WriteLocalized(mapper, *run.snapshot, arguments, out);
  const MapSource source{[&](const LevelMap& map) { return mapper.ModelOf(map); },
                         [&](const ModelImage& image) { return FindPicture(datasets, image); }};
  WriteResults(run, source, arguments, out);
  return 0;
}

}  // namespace rovio_sfm
