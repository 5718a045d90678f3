#include "rovio_sfm/app/write_maps.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <utility>

#include "rovio_sfm/app/map_file_list.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

using Path = std::filesystem::path;

// Without folders of pictures: their pictures.
void AppendFiles(const WrittenFiles& written, std::vector<Path>* files) {
  std::copy_if(written.paths.begin(), written.paths.end(), std::back_inserter(*files),
               [](const Path& path) { return !std::filesystem::is_directory(path); });
  files->insert(files->end(), written.pictures.begin(), written.pictures.end());
}

void AddDefaultFiles(const Path& folder, std::set<Path>* files) {
  for (const MapFormat format : kDefaultFormats) {
    const Path file = std::filesystem::absolute(folder / MainPathOf(format));
    if (std::filesystem::exists(file)) files->insert(file);
  }
}

}  // namespace

std::vector<WrittenMap> WriteAllMaps(const MapSnapshot& snapshot, const MapSource& source,
                                     const MapFormats& formats, const Path& folder,
                                     Overwrite overwrite) {
  std::vector<WrittenMap> written;
  std::vector<Path> fresh;
  for (const LevelMap& map : FindMapsBySize(snapshot)) {
    const Path place = FolderOfMap(folder, written.size());
    std::filesystem::create_directories(place);
    const WrittenFiles files = WriteMapFiles(map, source, formats, place, overwrite);
    if (place != folder && std::filesystem::is_empty(place)) std::filesystem::remove(place);
    AppendFiles(files, &fresh);
    AddListedFiles(folder, fresh);
    written.push_back({map.id, PosedImages(map).size(), map.scale.has_value(),
                       std::filesystem::absolute(place), files.paths, files.left_out,
                       files.densified});
  }
  if (overwrite == Overwrite::kAllow && !written.empty()) RemoveListedBut(folder, fresh);
  return written;
}

std::string Describe(const WrittenMap& map) {
  return "map " + std::to_string(map.id.value) + ": " + CountText(map.num_images, "image") +
         ", in " + (map.is_metric ? "metres" : "map units") + ", in " + map.folder.string();
}

std::vector<Path> FindMapFiles(const Path& folder) {
  static const std::regex kMapFolder("map_[0-9]+");
  std::set<Path> files;
  if (!std::filesystem::is_directory(folder)) return {};
  for (Path& file : ListedMapFiles(folder)) files.insert(std::move(file));
  AddDefaultFiles(folder, &files);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (std::regex_match(entry.path().filename().string(), kMapFolder)) {
      AddDefaultFiles(entry.path(), &files);
    }
  }
  return {files.begin(), files.end()};
}

}  // namespace rovio_sfm
