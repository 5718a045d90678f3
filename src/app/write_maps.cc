#include "rovio_sfm/app/write_maps.h"

#include <algorithm>
#include <regex>
#include <set>

#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

using Path = std::filesystem::path;

Path FolderOf(const Path& folder, size_t rank) {
  return rank == 0 ? folder : folder / ("map_" + std::to_string(rank + 1));
}

void AddMapFiles(const Path& folder, std::vector<Path>* files) {
  static const std::regex kName("trajectory(_[^/]+)?\\.txt|cloud\\.ply|map\\.png");
  if (!std::filesystem::is_directory(folder)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (std::regex_match(entry.path().filename().string(), kName)) files->push_back(entry.path());
  }
}

void RemoveOlder(const Path& folder, const std::vector<WrittenMap>& maps) {
  std::set<Path> fresh;
  for (const WrittenMap& map : maps) fresh.insert(map.files.begin(), map.files.end());
  for (const Path& file : FindMapFiles(folder)) {
    if (fresh.count(std::filesystem::absolute(file)) > 0) continue;
    std::filesystem::remove(file);
    const Path parent = file.parent_path();
    if (parent != folder && std::filesystem::is_empty(parent)) std::filesystem::remove(parent);
  }
}

}  // namespace

std::vector<WrittenMap> WriteAllMaps(const MapSnapshot& snapshot, const MapSource& source,
                                     const MapFormats& formats, const Path& folder,
                                     Overwrite overwrite) {
  std::vector<WrittenMap> written;
  for (const LevelMap& map : FindMapsBySize(snapshot)) {
    const Path place = FolderOf(folder, written.size());
    std::filesystem::create_directories(place);
    const WrittenFiles files = WriteMapFiles(map, source, formats, place, overwrite);
    if (place != folder && std::filesystem::is_empty(place)) std::filesystem::remove(place);
    written.push_back({map.id, PosedImages(map).size(), map.scale.has_value(),
                       std::filesystem::absolute(place), files.paths, files.left_out,
                       files.densified});
  }
  if (overwrite == Overwrite::kAllow) RemoveOlder(folder, written);
  return written;
}

std::string Describe(const WrittenMap& map) {
  return "map " + std::to_string(map.id.value) + ": " + CountText(map.num_images, "image") +
         ", in " + (map.is_metric ? "metres" : "map units") + ", in " + map.folder.string();
}

std::vector<Path> FindMapFiles(const Path& folder) {
  static const std::regex kMapFolder("map_[0-9]+");
  std::vector<Path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  AddMapFiles(folder, &files);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!std::regex_match(entry.path().filename().string(), kMapFolder)) continue;
    if (!entry.is_symlink()) AddMapFiles(entry.path(), &files);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace rovio_sfm
