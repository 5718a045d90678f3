#include "rovio_sfm/tools/map_tool.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <ostream>
#include <stdexcept>

#include "rovio_sfm/app/mapper.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/tools/copy_store.h"
#include "rovio_sfm/tools/store_contents.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/parse_arguments.h"

namespace rovio_sfm {
namespace {

struct Arguments {
  std::string file, second, out, formats;
  PruneChoice prune;
  std::optional<uint32_t> map;
  bool overwrite = false;
};

void TellCopy(const StoreCopyReport& report, const std::string& file, std::ostream& out) {
  for (const std::string& lost : report.lost) out << "lost: " << lost << "\n";
  out << "copied " << CountText(report.num_frames, "frame") << ", "
      << CountText(report.num_sessions, "session") << " and "
      << CountText(report.num_edits, "overlap") << "\nwrote "
      << std::filesystem::absolute(file).string() << "\n";
}

int Check(const Arguments& arguments, std::ostream& out) {
  const std::vector<std::string> faults = FindStoreFaults(arguments.file);
  for (const std::string& fault : faults) out << fault << "\n";
  out << arguments.file << ": "
      << (faults.empty() ? "sound" : CountText(faults.size(), "fault") + "; see map_tool repair")
      << "\n";
  return faults.empty() ? 0 : 1;
}

int Prune(const Arguments& arguments, std::ostream& out) {
  if (!arguments.prune.images && !arguments.prune.descriptors) {
    throw std::runtime_error("prune: expected --images, --descriptors or both");
  }
  const StorePruneReport report = PruneStore(arguments.file, arguments.prune);
  out << "forgot " << CountText(report.num_rows, "row") << ": " << report.bytes_before / 1024
      << " KiB before, " << report.bytes_after / 1024 << " KiB now\n";
  return 0;
}

int Export(const Arguments& arguments, std::ostream& out) {
  MapStore store(arguments.file, StoreAccess::kRead);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  mapper.Restore(&store);
  const auto snapshot = mapper.Snapshot();
  const auto map =
      arguments.map ? FindLevelMap(*snapshot, MapId{*arguments.map}) : FindLargestMap(*snapshot);
  if (!map) {
    const std::string wanted = arguments.map ? "map = " + std::to_string(*arguments.map) : "map";
    throw std::runtime_error(arguments.file + ": " + wanted + ": expected one with posed frames");
  }
  const MapFormats formats = ReadFormats(arguments.formats);
  const Overwrite overwrite = arguments.overwrite ? Overwrite::kAllow : Overwrite::kRefuse;
  const MapSource source{
      [&](const LevelMap& level_map) { return mapper.ModelOf(level_map); },
      [&](const ModelImage& image) { return store.frames().ReadImage(image.id); },
      PageNotes{mapper.MergeReports()},
      [&](const ModelImage& image) { return store.Get(image.id); }};
  std::filesystem::create_directories(arguments.out);
  const WrittenFiles written = WriteMapFiles(*map, source, formats, arguments.out, overwrite);
  PrintWritten(written, out);
  return written.paths.empty() ? 1 : 0;
}

CLI::App* AddCommand(const std::string& name, const std::string& what, Arguments* arguments,
                     CLI::App* app) {
  CLI::App* const command = app->add_subcommand(name, what);
  command->add_option("file", arguments->file, "map store (map.db of an output folder)")
      ->required();
  return command;
}

// Where each command stands that the arguments may name.
struct Commands {
  CLI::App *info, *check, *repair, *prune, *export_files, *merge;
};

Commands Declare(Arguments* arguments, CLI::App* app) {
  app->require_subcommand(1);
  Commands commands{
      AddCommand("info", "what a store holds", arguments, app),
      AddCommand("check", "everything that is wrong with a store; status 1 if anything is",
                 arguments, app),
      AddCommand("repair", "copies what reads into a new store; status 1 if anything is lost",
                 arguments, app),
      AddCommand("prune", "forgets what takes space", arguments, app),
      AddCommand("export", "writes a map in other programs' formats", arguments, app),
      AddCommand("merge", "puts two stores into a new one; nothing is matched", arguments, app)};
  commands.merge->add_option("second", arguments->second, "its sessions are numbered after")
      ->required();
  for (CLI::App* command : {commands.repair, commands.merge}) {
    command->add_option("out", arguments->out, "new store")->required();
  }
  commands.prune->add_flag("--images", arguments->prune.images, "the pictures");
  commands.prune->add_flag("--descriptors", arguments->prune.descriptors,
                           "what frames are recognised by: no merges or localisation there");
  commands.prune->add_option("--drive", arguments->prune.drives,
                             "of this drive alone (see info); may be repeated");
  commands.export_files->add_option("--out", arguments->out, "folder for the files")->required();
  commands.export_files->add_option("--format", arguments->formats,
                                    "with commas between: " + FormatNames());
  commands.export_files->add_option("--map", arguments->map, "else the largest")
      ->check(CLI::Range(uint32_t{1}, std::numeric_limits<uint32_t>::max()));
  commands.export_files->add_flag("--overwrite", arguments->overwrite, "replace files");
  return commands;
}

}  // namespace

int MapToolCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Looks at map stores, checks, repairs, prunes, exports and merges them");
  Arguments arguments;
  const Commands commands = Declare(&arguments, &app);
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  if (commands.check->parsed()) return Check(arguments, out);
  if (commands.prune->parsed()) return Prune(arguments, out);
  if (commands.export_files->parsed()) return Export(arguments, out);
  if (commands.info->parsed()) {
    TellContents(arguments.file, out);
    return 0;
  }
  const StoreCopyReport report = commands.merge->parsed()
                                     ? MergeStores(arguments.file, arguments.second, arguments.out)
                                     : RepairStore(arguments.file, arguments.out);
  TellCopy(report, arguments.out, out);
  return report.lost.empty() ? 0 : 1;
}

}  // namespace rovio_sfm
