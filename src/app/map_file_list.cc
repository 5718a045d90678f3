#include "rovio_sfm/app/map_file_list.h"

#include <fstream>
#include <set>
#include <system_error>

#include "rovio_sfm/io/write_file.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

constexpr char kTitle[] =
    "# Written here by rovio_sfm: --overwrite and --resume remove what they do not write again.\n";

bool IsBelow(const fs::path& name) {
  const fs::path normal = name.lexically_normal();
  return !normal.empty() && normal.is_relative() && *normal.begin() != ".." && normal != ".";
}

bool HasLink(const fs::path& folder, const fs::path& name) {
  fs::path place = folder;
  for (const fs::path& part : name.parent_path()) {
    place /= part;
    if (fs::is_symlink(place)) return true;
  }
  return false;
}

// Relative names.
std::set<fs::path> ReadList(const fs::path& folder) {
  std::set<fs::path> names;
  std::ifstream list(folder / kMapFileList);
  for (std::string line; std::getline(list, line);) {
    const fs::path name = fs::path(line).lexically_normal();
    if (line.empty() || line[0] == '#' || !IsBelow(name) || HasLink(folder, name)) continue;
    names.insert(name);
  }
  return names;
}

void WriteList(const fs::path& folder, const std::set<fs::path>& names) {
  if (names.empty()) {
    fs::remove(folder / kMapFileList);
    return;
  }
  std::string text = kTitle;
  for (const fs::path& name : names) text += name.string() + "\n";
  WriteFile(folder / kMapFileList, text, Overwrite::kAllow);
}

std::set<fs::path> NamesOf(const fs::path& folder, const std::vector<fs::path>& files) {
  std::set<fs::path> names;
  for (const fs::path& file : files) {
    names.insert(fs::absolute(file).lexically_relative(fs::absolute(folder)).lexically_normal());
  }
  return names;
}

void RemoveWithEmptyFolders(const fs::path& folder, const fs::path& name) {
  std::error_code ignored;  // of a folder that is not empty
  fs::remove(folder / name);
  for (fs::path parent = name.parent_path(); !parent.empty(); parent = parent.parent_path()) {
    if (!fs::is_empty(folder / parent, ignored) || ignored) return;
    fs::remove(folder / parent);
  }
}

}  // namespace

std::vector<fs::path> ListedFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::path& name : ReadList(folder)) {
    if (fs::is_regular_file(folder / name)) files.push_back(fs::absolute(folder / name));
  }
  return files;
}

void AddListedFiles(const fs::path& folder, const std::vector<fs::path>& files) {
  std::set<fs::path> names = ReadList(folder);
  names.merge(NamesOf(folder, files));
  WriteList(folder, names);
}

void RemoveListedBut(const fs::path& folder, const std::vector<fs::path>& fresh) {
  const std::set<fs::path> kept = NamesOf(folder, fresh);
  for (const fs::path& file : ListedFiles(folder)) {
    const fs::path name = file.lexically_relative(fs::absolute(folder));
    if (kept.count(name) == 0) RemoveWithEmptyFolders(folder, name);
  }
  WriteList(folder, kept);
}

}  // namespace rovio_sfm
