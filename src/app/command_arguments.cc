#include "rovio_sfm/app/command_arguments.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/app/map_file_list.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/load_document.h"

namespace rovio_sfm {
namespace {

constexpr int kNothingPosed = 2;  // exit status

// Of a pipe too.
std::string ReadTextOf(const std::string& path) {
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(path + ": is a folder; expected a YAML file");
  }
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  return text.str();
}

template <typename Options>
void LoadFile(const std::string& path, Options* options) {
  if (path.empty()) return;
  const std::string yaml = ReadTextOf(path);
  try {
    LoadOptions(LoadDocument(yaml), "", options);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

// Why no image was posed in the map, by figures.
std::string WhyNowhere(const PlaceCounters& places) {
  std::ostringstream why;
  why << "nowhere: of " << places.queries << " images looked up " << places.matched_queries
      << " match a place of the map and " << places.low_score << " resemble none; of "
      << places.candidates << " places proposed " << places.refused_geometry + places.refused_spread
      << " show another arrangement of points";
  return why.str();
}

// Those of an earlier run may lie beside other maps.
void ReplaceLocalized(const std::filesystem::path& folder,
                      std::vector<std::filesystem::path> written) {
  for (std::filesystem::path& file : ListedMapFiles(folder)) written.push_back(std::move(file));
  RemoveListedBut(folder, written);
}

size_t CountMaps(const MapSnapshot& snapshot,
                 const std::map<FrameId, Localization>& localizations) {
  std::set<MapId> maps;
  for (const auto& [id, pose] : localizations) {
    const SessionSnapshot* session = FindSession(snapshot, pose.session);
    if (session != nullptr) maps.insert(session->map);
  }
  return maps.size();
}

void DeclareOptionFiles(CLI::App* app, MappingArguments* arguments) {
  app->add_option("--frontend", arguments->frontend_file, "YAML as config/frontend.yaml");
  app->add_option("--mapper", arguments->mapper_file, "YAML as config/mapping.yaml");
}

}  // namespace

void DeclareMappingArguments(CLI::App* app, MappingArguments* arguments) {
  app->add_option("--out", arguments->out, "folder for the results")->required();
  DeclareOptionFiles(app, arguments);
  app->add_option("--mode", arguments->mode, "every: stills; parallax: video")
      ->check(CLI::IsMember({"every", "parallax"}));
  app->add_option("--features", arguments->features, "most features of an image");
  app->add_option("--threads", arguments->mapper.num_threads, "never changes the result");
  app->add_option("--seed", arguments->mapper.seed, "of everything random");
  app->add_option("--places", arguments->places,
                  "place model for merging and loops; none: without; else the shipped one");
  app->add_option("--max-overlaps", arguments->mapper.mapper.merge.max_overlaps,
                  "overlaps used of two drives; 0: all");
  app->add_flag("!--no-pose-graph", arguments->mapper.mapper.merge.use_pose_graph,
                "close loops by adjustment alone");
  app->add_flag(
      "--seeded", arguments->mapper.seeded,
      "the thesis's Algorithms 1 to 3: places of all drives first, then each from the last");
  app->add_option("--format", arguments->format,
                  "what maps are written as: some of " + FormatNames() +
                      " with commas between them; tum,ply where not given");
  app->add_flag("--densify", arguments->densify,
                "also densified.ply: matched again with the poses fixed");
  CLI::Option* const overwrite =
      app->add_flag("--overwrite", arguments->overwrite, "replace the results of an earlier run");
  CLI::Option* const resume = app->add_flag(
      "--resume", arguments->resume,
      "go on with the maps that the folder holds; a drive that is there goes on after its end");
  resume->excludes(overwrite)->excludes("--seeded");
  app->add_flag(
         "--localize", arguments->mapper.localize,
         "pose the images in the maps that the folder holds, which stay; write localized.txt")
      ->excludes(overwrite)
      ->excludes(resume)
      ->excludes("--seeded");
  app->add_flag("--keep-images", arguments->mapper.frontend.keep_images,
                "map.db keeps the pictures, for depth and exports");
  app->add_flag("!--no-store", arguments->store, "keep no map.db: nothing to resume from")
      ->excludes(resume)
      ->excludes("--localize");
}

void CompleteMappingArguments(MappingArguments* arguments) {
  FrontendOptions& frontend = arguments->mapper.frontend;
  LoadFile(arguments->frontend_file, &frontend);
  LoadFile(arguments->mapper_file, &arguments->mapper.mapper);
  if (arguments->mode == "every") frontend.choose.mode = KeyframeMode::kEvery;
  if (arguments->mode == "parallax") frontend.choose.mode = KeyframeMode::kParallax;
  if (arguments->features) frontend.extract.max_features = *arguments->features;
  arguments->mapper.mapper.seed = arguments->mapper.seed;
  arguments->formats = ReadFormats(arguments->format);
  if (arguments->densify) arguments->formats.insert(MapFormat::kDensified);
  std::string error;
  if (!IsValid(arguments->mapper, &error)) throw std::runtime_error(error);
}

std::unique_ptr<StoreFolder> OpenResultStore(const MappingArguments& arguments) {
  if (!arguments.store) return nullptr;
  ExistingStore existing = ExistingStore::kRefuse;
  if (arguments.overwrite) existing = ExistingStore::kReplace;
  if (arguments.resume) existing = ExistingStore::kResume;
  if (arguments.mapper.localize) existing = ExistingStore::kRead;
  MapStoreOptions options;
  options.keep_images = arguments.mapper.frontend.keep_images;
  return std::make_unique<StoreFolder>(arguments.out, existing, options);
}

void TellStore(const StoreFolder* store, std::ostream& out) {
  if (store == nullptr || !store->IsWritten()) return;
  const std::string& error = store->store().error();
  const std::string file = std::filesystem::absolute(store->store().file()).string();
  if (error.empty()) {
    out << "wrote " << file << "\n";
  } else {
    out << "warning: " << file << " was not kept to the end: " << error << "\n";
  }
}

int WriteLocalized(const OfflineMapper& mapper, const MapSnapshot& snapshot,
                   const ReasonCounts& left_out, const MappingArguments& arguments,
                   std::ostream& out) {
  const WrittenFiles written = WriteFiles(LocalizedFiles(snapshot, mapper.localizations()),
                                          arguments.out, Overwrite::kAllow);
  ReplaceLocalized(arguments.out, written.paths);
  out << mapper.localizations().size() << " of "
      << CountText(mapper.frontend_counters().images, "image") << " posed in the map"
      << (CountMaps(snapshot, mapper.localizations()) > 1 ? "s, of which each has a file" : "")
      << "\n";
  PrintWritten(written, out);
  if (!left_out.empty()) out << "left out:\n" << ReasonTable(left_out);
  if (!mapper.localizations().empty()) return 0;
  out << WhyNowhere(mapper.place_counters()) << "\n";
  return kNothingPosed;
}

Overwrite MayReplaceResults(const MappingArguments& arguments) {
  return arguments.overwrite || arguments.resume ? Overwrite::kAllow : Overwrite::kRefuse;
}

}  // namespace rovio_sfm
