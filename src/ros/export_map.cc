#include "rovio_sfm/ros/export_map.h"

#include <exception>

#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/ros/export_folder.h"
#include "rovio_sfm/ros/status.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

// False, and the status says which file stands there.
bool MayWrite(const std::filesystem::path& folder, const MapFormats& formats, bool overwrite,
              Status* status) {
  try {
    if (!overwrite) RequireNoFiles(folder, formats);
    return true;
  } catch (const std::exception& error) {
    *status = AlreadyExists(std::string(error.what()) + ", as overwrite was false");
    return false;
  }
}

void Write(const LevelMap& map, const MapSource& source, const MapFormats& formats,
           const std::filesystem::path& folder, Overwrite overwrite, ExportMapResponse* response) {
  std::filesystem::create_directories(folder);
  const WrittenFiles written = WriteMapFiles(map, source, formats, folder, overwrite);
  for (const std::filesystem::path& path : written.paths) response->files.push_back(path.string());
  std::string message = "map " + std::to_string(map.id.value) + " written to " +
                        std::filesystem::absolute(folder).string();
  if (!written.missing_pictures.empty()) {
    message += "; " + CountWere(written.missing_pictures.size(), "picture") + " not at hand";
  }
  for (const std::string& sentence : written.left_out) message += "; " + sentence;
  response->status = Ok(message);
  if (written.paths.empty()) response->status = FailedPrecondition(written.left_out.front());
}

bool ReadFormatNames(const std::string& names, MapFormats* formats, Status* status) {
  try {
    *formats = ReadFormats(names, "formats");
    return true;
  } catch (const std::exception& error) {
    *status = InvalidArgument(error.what());
    return false;
  }
}

}  // namespace

std::optional<LevelMap> FindRequestedMap(const MapSnapshot& snapshot,
                                         const ExportMapRequest& request) {
  return request.map == 0 ? FindLargestMap(snapshot) : FindLevelMap(snapshot, MapId{request.map});
}

ExportMapResponse ExportMapFiles(const MapSnapshot& snapshot, const MapSource& source,
                                 const std::string& output_dir, const ExportMapRequest& request) {
  ExportMapResponse response;
  MapFormats formats;
  const auto folder = FindExportFolder(output_dir, request.name, &response.status);
  if (!folder || !ReadFormatNames(request.formats, &formats, &response.status)) return response;
  const auto map = FindRequestedMap(snapshot, request);
  if (!map) {
    response.status =
        NotFound("map = " + std::to_string(request.map) + ": expected " +
                 (request.map == 0 ? "a map with a posed frame; there is none yet"
                                   : "the number of a map with a posed frame, or 0, the largest"));
    return response;
  }
  if (!MayWrite(*folder, formats, request.overwrite, &response.status)) return response;
  try {
    const Overwrite overwrite = request.overwrite ? Overwrite::kAllow : Overwrite::kRefuse;
    Write(*map, source, formats, *folder, overwrite, &response);
  } catch (const std::exception& error) {  // a full disk, a read-only folder
    response.status = Internal(error.what());
  }
  return response;
}

}  // namespace rovio_sfm
