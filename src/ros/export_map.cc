#include "rovio_sfm/ros/export_map.h"

#include <algorithm>
#include <cctype>
#include <exception>

#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/ros/status.h"

namespace rovio_sfm {
namespace {

// A plain folder name: nothing that could lead out of the output folder.
bool IsFolderName(const std::string& name) {
  const bool is_plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
  return is_plain && name.size() <= 64 && (name.empty() || name.front() != '.');
}

// Where links in the folder lead elsewhere, nothing is written.
bool StaysInside(const std::filesystem::path& folder, const std::filesystem::path& output_dir) {
  const std::filesystem::path inside = std::filesystem::weakly_canonical(folder).lexically_relative(
      std::filesystem::weakly_canonical(output_dir));
  return !inside.empty() && *inside.begin() != "..";
}

void Write(const LevelMap& map, const std::filesystem::path& folder, bool overwrite,
           ExportMapResponse* response) {
  if (!overwrite && std::filesystem::exists(folder / "cloud.ply")) {
    response->status =
        AlreadyExists((folder / "cloud.ply").string() + " exists and overwrite was false");
    return;
  }
  std::filesystem::create_directories(folder);
  for (const std::filesystem::path& path :
       WriteMapFiles(map, folder, overwrite ? Overwrite::kAllow : Overwrite::kRefuse)) {
    response->files.push_back(path.string());
  }
  response->status = Ok("map " + std::to_string(map.id.value) + " written to " +
                        std::filesystem::absolute(folder).string());
}

}  // namespace

ExportMapResponse ExportMapFiles(const MapSnapshot& snapshot, const std::string& output_dir,
                                 const ExportMapRequest& request) {
  ExportMapResponse response;
  if (output_dir.empty()) {
    response.status = FailedPrecondition("the parameter ~output_dir is not set");
    return response;
  }
  if (!IsFolderName(request.name)) {
    response.status =
        InvalidArgument("name: expected at most 64 of A-Z a-z 0-9 _ - ., not beginning with .");
    return response;
  }
  const auto map =
      request.map == 0 ? FindLargestMap(snapshot) : FindLevelMap(snapshot, MapId{request.map});
  if (!map) {
    response.status = NotFound("map: there is no such map with a posed frame");
    return response;
  }
  try {
    const std::filesystem::path folder = std::filesystem::path(output_dir) / request.name;
    if (!StaysInside(folder, output_dir)) {
      response.status = InvalidArgument("name: " + folder.string() +
                                        " is a link that leads out of " + output_dir);
      return response;
    }
    Write(*map, folder, request.overwrite, &response);
  } catch (const std::exception& error) {  // a full disk, a read-only folder
    response.status = Internal(error.what());
  }
  return response;
}

}  // namespace rovio_sfm
