#include "rovio_sfm/app/finish_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/app/output_folder.h"
#include "rovio_sfm/app/wait_for_end.h"
#include "rovio_sfm/app/write_maps.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/peak_memory.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

using Path = std::filesystem::path;
using Json = nlohmann::ordered_json;

constexpr uintmax_t kBytesOfStore = 150u << 10;  // an image, its features and its JPEG
constexpr uintmax_t kBytesOfMap = 10u << 10;     // an image, its pose and its landmarks
constexpr uintmax_t kSpareBytes = 1u << 20;

Path SummaryPath(const MappingArguments& arguments) { return Path(arguments.out) / "summary.json"; }

// What the mapper knows; its threads rest.
void Complete(const RunToFinish& finish, MapRun* run) {
  const OfflineMapper& mapper = *finish.mapper;
  run->drives = mapper.drives();
  run->frontend = mapper.frontend_counters();
  run->funnel = mapper.matching_funnel();
  run->mapper = mapper.mapper_counters();
  run->merges = mapper.merge_reports();
  run->places = mapper.place_counters();
  run->landmarks = mapper.landmark_counts();
  run->num_rejoined = mapper.num_rejoined();
  run->motion = mapper.motion_counts();
  AddReasons(mapper.reasons(), &run->left_out);
  run->stages = finish.times->totals();
  run->wall_s = 1e-9 * static_cast<double>(SteadyNs() - finish.start_ns);
  run->peak_rss_mb = PeakMemoryMb();
}

PageNotes NotesOf(const MapRun& run) {
  PageNotes notes;
  notes.merges = run.merges;
  for (const auto& [stage, total] : run.stages) {
    const auto num_images = static_cast<double>(std::max<size_t>(run.num_images, 1));
    notes.stage_ms.push_back({stage, 1e-6 * static_cast<double>(total.total_ns) / num_images});
  }
  const std::string why = WhyInMapUnits(run);
  if (!why.empty()) notes.warnings.push_back("Not metric: " + why + ".");
  for (const auto& [reason, count] : run.left_out) {
    notes.warnings.push_back(std::to_string(count) + " × left out: " + reason);
  }
  return notes;
}

Json FormatsLeftOut(const std::vector<WrittenMap>& maps) {
  Json sentences = Json::array();
  for (const WrittenMap& map : maps) {
    for (const std::string& sentence : map.left_out) {
      sentences.push_back("map " + std::to_string(map.id.value) + ": " + sentence);
    }
  }
  return sentences;
}

std::vector<WrittenMap> WriteResults(const RunToFinish& finish, const MapRun& run, Json summary,
                                     const MapFormats& formats, Overwrite overwrite) {
  if (run.stopped && FindMapsBySize(*run.snapshot).empty()) return {};
  const HoldSecondStop hold;
  const MapSource source{
      [&](const LevelMap& map) { return finish.mapper->ModelOf(map); }, finish.pictures,
      NotesOf(run), [&](const ModelImage& image) { return finish.mapper->frames().Get(image.id); }};
  std::vector<WrittenMap> maps =
      WriteAllMaps(*run.snapshot, source, formats, finish.arguments->out, overwrite);
  summary.update(MapSummaryJson(run));
  summary["formats_left_out"] = FormatsLeftOut(maps);
  if (!maps.empty() && maps[0].densified) summary["densified"] = DensifyJson(*maps[0].densified);
  WriteFile(SummaryPath(*finish.arguments), summary.dump(2) + "\n", overwrite);
  return maps;
}

// What is written as soon as there is a map; what takes long waits for the final one.
MapFormats QuickOnes(const MapFormats& formats) {
  MapFormats quick;
  for (const MapFormat format : formats) {
    if (!TakesLong(format)) quick.insert(format);
  }
  return quick;
}

[[noreturn]] void EndUnadjusted(const std::vector<WrittenMap>& maps, std::ostream& out) {
  out << "no time was left for the final adjustment; the maps are as they stood at the signal\n";
  for (const WrittenMap& map : maps) out << Describe(map) << "\n";
  out.flush();
  std::_Exit(StatusOfStop());
}

void Tell(const RunToFinish& finish, const MapRun& run, const std::vector<WrittenMap>& maps,
          std::ostream& out) {
  TellStore(finish.store, out);
  out << CountText(run.mapper.global_adjustments, "global adjustment") << "\n"
      << CountText(run.snapshot->sessions.size(), "session") << "; "
      << CountText(maps.empty() ? 0 : maps[0].num_images, "image")
      << " posed in the largest map, in "
      << (!maps.empty() && maps[0].is_metric ? "metres" : "map units") << "\n";
  out << RefinedCameras(run);
  const std::string why = WhyInMapUnits(run);
  if (!maps.empty() && !why.empty()) out << "not metric: " << why << "\n";
  for (const WrittenMap& map : maps) {
    out << Describe(map) << "\n";
    for (const std::string& sentence : map.left_out) out << sentence << "\n";
    if (map.densified) out << Describe(*map.densified) << "\n";
    for (const Path& file : map.files) out << "wrote " << file.string() << "\n";
  }
  if (!run.stopped || !maps.empty()) {
    out << "wrote " << std::filesystem::absolute(SummaryPath(*finish.arguments)).string() << "\n";
  }
  if (!run.left_out.empty()) out << "left out:\n" << ReasonTable(run.left_out);
}

// Why no map was started, or none of most images, by figures, in one sentence.
std::string WhyUnposed(const MapRun& run, const BootstrapOptions& start) {
  if (run.frontend.keyframes == 0) return "the reasons stand above";
  if (run.funnel.pairs == 0) return "no two of them were compared";
  const auto pairs = static_cast<double>(run.funnel.pairs);
  std::ostringstream why;
  why << "each shows " << std::lround(static_cast<double>(run.funnel.features) / pairs)
      << " features and shares " << std::lround(static_cast<double>(run.funnel.guided) / pairs)
      << " points with the one before it, in the mean; a map starts from two that share "
      << start.min_inliers << " from places far enough apart (bootstrap.min_inliers)";
  return why.str();
}

bool HasFiles(const std::vector<WrittenMap>& maps) {
  return std::any_of(maps.begin(), maps.end(),
                     [](const WrittenMap& map) { return !map.files.empty(); });
}

int StatusOf(const RunToFinish& finish, const std::vector<WrittenMap>& maps, std::ostream& out) {
  const MapRun& run = finish.run;
  if (run.stopped) {
    out << "stopped by a signal: " << run.frontend.images << " of "
        << CountWere(run.num_images, "image") << " looked at\n";
    return StatusOfStop();
  }
  const std::string why = WhyUnposed(run, finish.arguments->mapper.mapper.bootstrap);
  const size_t num_unposed = CountImagesWithoutPose(run);
  if (!maps.empty() && 2 * num_unposed > run.num_images) {
    out << num_unposed << " of " << CountText(run.num_images, "image")
        << (num_unposed == 1 ? " has" : " have") << " no pose: " << why << "\n";
  }
  if (!maps.empty()) return HasFiles(maps) ? 0 : kNothingWritten;
  out << "no image was registered: of " << CountText(run.num_images, "image") << " "
      << run.frontend.keyframes << " became "
      << (run.frontend.keyframes == 1 ? "a keyframe; " : "keyframes; ") << why << "\n";
  return kNothingRegistered;
}

// A folder without maps stays as it is, and is not made.
void RequireStore(const Path& folder) {
  const Path file = StoreFolder::FileIn(folder);
  if (std::filesystem::exists(file)) return;
  throw std::runtime_error(file.string() +
                           ": no such file; --localize expected the maps of an earlier run");
}

}  // namespace

void RefuseOlderResults(const MappingArguments& arguments) {
  std::vector<Path> older = FindMapFiles(arguments.out);
  if (arguments.mapper.localize) return;
  if (std::filesystem::exists(SummaryPath(arguments))) older.push_back(SummaryPath(arguments));
  for (const MapFormat format : arguments.formats) {
    const Path path = Path(arguments.out) / MainPathOf(format);
    if (std::filesystem::exists(path)) older.push_back(path);
  }
  if (!older.empty() && !arguments.overwrite && !arguments.resume) {
    throw std::runtime_error(older.front().string() +
                             " exists; give --resume to go on with it, --overwrite to replace it");
  }
}

void PrepareMapFolder(const MappingArguments& arguments, size_t num_images) {
  if (arguments.mapper.localize) RequireStore(arguments.out);
  const uintmax_t of_image = kBytesOfMap + (arguments.store ? kBytesOfStore : 0);
  RequireWritableFolder(arguments.out, kSpareBytes + num_images * of_image);
}

namespace {

int Finish(RunToFinish finish, const Json& header, std::ostream& out) {
  finish.run.stopped = IsStopRequested();
  finish.run.snapshot = finish.mapper->Drain();
  if (finish.arguments->mapper.localize) {
    AddReasons(finish.mapper->reasons(), &finish.run.left_out);
    return WriteLocalized(*finish.mapper, *finish.run.snapshot, finish.run.left_out,
                          *finish.arguments, out);
  }
  MapRun first = finish.run;
  Complete(finish, &first);
  const MapFormats& formats = finish.arguments->formats;
  std::vector<WrittenMap> maps =
      WriteResults(finish, first, header, QuickOnes(formats), MayReplaceResults(*finish.arguments));
  if (finish.store != nullptr && !maps.empty()) finish.store->DropReplaced();
  finish.run.snapshot =
      EndInTime([&] { return finish.mapper->Finish(); }, [&] { EndUnadjusted(maps, out); });
  Complete(finish, &finish.run);
  maps = WriteResults(finish, finish.run, header, formats, Overwrite::kAllow);
  Tell(finish, finish.run, maps, out);
  return StatusOf(finish, maps, out);
}

}  // namespace

int FinishRun(RunToFinish finish, const Json& header, std::ostream& out) {
  const StoreFolder* const store = finish.store;
  try {
    return Finish(std::move(finish), header, out);
  } catch (const std::exception&) {  // a full disk: whether the maps are kept is told all the same
    TellStore(store, out);
    throw;
  }
}

}  // namespace rovio_sfm
